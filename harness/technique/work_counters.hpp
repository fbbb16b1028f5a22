#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"

#include <cstddef>
#include <cstdint>

namespace reliefbench {

/// What probed compilations count in: the mirror of harness/shaders/work_counters.glsl. Four numbers of vertex and
/// tessellation stages, or of a preparation pass, then four for each pixel.
class WorkCounters {
public:
    struct Stages {
        std::uint32_t taps = 0;
        std::uint32_t texels = 0;
        /// What the shaders' own loop is to count to.
        std::uint32_t turns_asked = 0;
        /// Invocations whose loops the device ended.
        std::uint32_t cuts = 0;
    };
    struct Pixel {
        std::uint32_t taps = 0;
        std::uint32_t texels = 0;
        std::uint32_t steps = 0;
        std::uint32_t flags = 0;

        bool is_covered() const { return (flags & covered_bit) != 0; }
        bool is_cut() const { return (flags & cut_bit) != 0; }
        std::uint32_t unconverged() const { return flags & ~(covered_bit | cut_bit); }
    };

    WorkCounters(const gpu::Device& device, std::size_t pixels);

    /// To 0, before what counts.
    void clear(const vk::raii::CommandBuffer& commands) const;

    /// After the submission has ended.
    Stages stages() const;
    Pixel pixel(std::size_t index) const;

    const vk::raii::Buffer& buffer() const { return buffer_.buffer; }

private:
    static constexpr std::uint32_t covered_bit = 0x80000000u;
    static constexpr std::uint32_t cut_bit = 0x40000000u;

    gpu::Buffer buffer_;
};

}  // namespace reliefbench
