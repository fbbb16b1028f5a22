#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace reliefbench {

/// What probed compilations count in: the mirror of harness/shaders/contract/work_counters.glsl. Eight numbers of
/// vertex and tessellation stages, or of a preparation pass, then four for each pixel.
class WorkCounters {
public:
    struct Stages {
        std::uint32_t taps = 0;
        std::uint32_t texels = 0;
        /// What the shaders' own loop is to count to.
        std::uint32_t turns_asked = 0;
        /// Invocations whose loops the device ended.
        std::uint32_t cuts = 0;
        /// Of a vertex out of its range (answer_fault.hpp), 0 where there is none, and the bits of its value.
        std::uint32_t fault = 0;
        std::uint32_t fault_bits = 0;
        std::array<std::uint32_t, 2> unused{};
    };
    struct Pixel {
        std::uint32_t taps = 0;
        std::uint32_t texels = 0;
        std::uint32_t steps_or_fault_bits = 0;
        std::uint32_t flags = 0;

        bool is_covered() const { return (flags & covered_bit) != 0; }
        bool is_cut() const { return (flags & cut_bit) != 0; }
        /// Of an answer out of its range, the number of an AnswerFault.
        std::uint32_t fault() const { return (flags & fault_mask) >> fault_shift; }
        std::uint32_t steps() const { return fault() != 0 ? 0 : steps_or_fault_bits; }
        std::uint32_t unconverged() const { return flags & ~(covered_bit | cut_bit | fault_mask); }
    };

    /// Of the block in GLSL.
    static constexpr const char* name = "work";

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
    static constexpr std::uint32_t fault_shift = 27;
    static constexpr std::uint32_t fault_mask = 0x38000000u;

    gpu::Buffer buffer_;
};

}  // namespace reliefbench
