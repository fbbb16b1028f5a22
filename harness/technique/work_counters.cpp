#include "technique/work_counters.hpp"

#include "gpu/commands.hpp"

#include <cstring>

namespace reliefbench {

namespace {

/// A loop that the device has ended before does one turn.
constexpr std::uint32_t turns_asked = 2;

}  // namespace

WorkCounters::WorkCounters(const gpu::Device& device, std::size_t pixels)
    : buffer_(device, sizeof(Stages) + pixels * sizeof(Pixel),
              vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst, true) {}

void WorkCounters::clear(const vk::raii::CommandBuffer& commands) const {
    constexpr vk::DeviceSize turns_begin = offsetof(Stages, turns_asked);
    constexpr vk::DeviceSize turns_end = turns_begin + sizeof(std::uint32_t);
    commands.fillBuffer(*buffer_.buffer, 0, turns_begin, 0);
    commands.fillBuffer(*buffer_.buffer, turns_begin, turns_end - turns_begin, turns_asked);
    commands.fillBuffer(*buffer_.buffer, turns_end, VK_WHOLE_SIZE, 0);
    gpu::full_barrier(commands);
}

WorkCounters::Stages WorkCounters::stages() const {
    Stages stages;
    std::memcpy(&stages, buffer_.mapped, sizeof stages);
    return stages;
}

WorkCounters::Pixel WorkCounters::pixel(std::size_t index) const {
    Pixel pixel;
    std::memcpy(&pixel, buffer_.mapped + sizeof(Stages) + index * sizeof pixel, sizeof pixel);
    return pixel;
}

}  // namespace reliefbench
