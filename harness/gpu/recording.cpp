#include "gpu/recording.hpp"

#include "gpu/commands.hpp"

#include <cassert>
#include <limits>
#include <utility>

namespace reliefbench::gpu {

namespace {

constexpr std::uint64_t forever = std::numeric_limits<std::uint64_t>::max();

}  // namespace

Recording::Recording(const Device& device, std::string what,
                     const std::function<void(const vk::raii::CommandBuffer&)>& record, int passes)
    : handles_(&device.handles()), what_(std::move(what)), passes_(passes) {
    translate_errors(what_, handles_->info.name, [&] {
        vk::raii::CommandBuffers buffers(handles_->device,
                                         vk::CommandBufferAllocateInfo{.commandPool = *handles_->command_pool,
                                                                       .level = vk::CommandBufferLevel::ePrimary,
                                                                       .commandBufferCount = 1});
        commands_ = std::move(buffers.front());
        commands_.begin(vk::CommandBufferBeginInfo{});
        record(commands_);
        // What the device wrote shall be visible to the host once the fence has been waited for.
        full_barrier(commands_);
        commands_.end();
        fence_ = vk::raii::Fence(handles_->device, vk::FenceCreateInfo{});
    });
}

Recording::~Recording() {
    if (!under_way_) return;
    try {
        wait();
    } catch (const Error&) {
        // A lost device ends its work, too.
    }
}

void Recording::submit() {
    assert(!under_way_ && "submitted again before its end was waited for");
    translate_errors(what_, handles_->info.name, [&] {
        handles_->device.resetFences(*fence_);
        const vk::CommandBufferSubmitInfo submitted{.commandBuffer = *commands_};
        if (handles_->on_submit) handles_->on_submit(passes_);
        try {
            handles_->queue.submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1, .pCommandBufferInfos = &submitted},
                                    *fence_);
        } catch (const vk::SystemError&) {
            if (handles_->on_end) handles_->on_end();
            throw;
        }
        under_way_ = true;
    });
}

void Recording::wait() {
    assert(under_way_);
    under_way_ = false;
    translate_errors(what_, handles_->info.name, [&] {
        try {
            const vk::Result result = handles_->device.waitForFences(*fence_, true, forever);
            if (result != vk::Result::eSuccess) vk::throwResultException(result, "vkWaitForFences");
        } catch (const vk::SystemError&) {
            // The commands are about to be freed: what was submitted must be over.
            handles_->wait_until_idle();
            if (handles_->on_end) handles_->on_end();
            throw;
        }
        if (handles_->on_end) handles_->on_end();
    });
}

}  // namespace reliefbench::gpu
