#include "gpu/commands.hpp"

#include "gpu/recording.hpp"

#include <string>

namespace reliefbench::gpu {

namespace {

constexpr auto everything_read_or_written = vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite;

}  // namespace

void submit_and_wait(const Device& device, std::string_view what,
                     const std::function<void(const vk::raii::CommandBuffer&)>& record) {
    Recording recording(device, std::string(what), record);
    recording.submit();
    recording.wait();
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
