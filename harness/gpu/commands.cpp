#include "gpu/commands.hpp"

#include <limits>

namespace reliefbench::gpu {

namespace {

constexpr auto everything_read_or_written = vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite;

}  // namespace

void submit_and_wait(const Device& device, std::string_view what,
                     const std::function<void(const vk::raii::CommandBuffer&)>& record) {
    const DeviceHandles& handles = device.handles();
    translate_errors(what, handles.info.name, [&] {
        vk::raii::CommandBuffers buffers(handles.device,
                                         vk::CommandBufferAllocateInfo{.commandPool = *handles.command_pool,
                                                                       .level = vk::CommandBufferLevel::ePrimary,
                                                                       .commandBufferCount = 1});
        const vk::raii::CommandBuffer& commands = buffers.front();
        commands.begin(vk::CommandBufferBeginInfo{.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        record(commands);
        // What the device wrote shall be visible to the host once the fence has been waited for.
        full_barrier(commands);
        commands.end();

        const vk::raii::Fence fence(handles.device, vk::FenceCreateInfo{});
        const vk::CommandBufferSubmitInfo submitted{.commandBuffer = *commands};
        handles.queue.submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1, .pCommandBufferInfos = &submitted}, *fence);
        const vk::Result result = handles.device.waitForFences(*fence, true, std::numeric_limits<std::uint64_t>::max());
        if (result != vk::Result::eSuccess)
            fail("cannot {}: waiting for the device gave {}", what, vk::to_string(result));
    });
}

void full_barrier(const vk::raii::CommandBuffer& commands) {
    const vk::MemoryBarrier2 barrier{
        .srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
        .srcAccessMask = everything_read_or_written,
        .dstStageMask = vk::PipelineStageFlagBits2::eAllCommands | vk::PipelineStageFlagBits2::eHost,
        .dstAccessMask = everything_read_or_written,
    };
    commands.pipelineBarrier2(vk::DependencyInfo{.memoryBarrierCount = 1, .pMemoryBarriers = &barrier});
}

void change_layout(const vk::raii::CommandBuffer& commands, vk::Image image, const vk::ImageSubresourceRange& range,
                   vk::ImageLayout from, vk::ImageLayout to) {
    const vk::ImageMemoryBarrier2 barrier{
        .srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
        .srcAccessMask = everything_read_or_written,
        .dstStageMask = vk::PipelineStageFlagBits2::eAllCommands,
        .dstAccessMask = everything_read_or_written,
        .oldLayout = from,
        .newLayout = to,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image,
        .subresourceRange = range,
    };
    commands.pipelineBarrier2(vk::DependencyInfo{.imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier});
}

}  // namespace reliefbench::gpu
