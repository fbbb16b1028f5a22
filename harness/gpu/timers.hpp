#pragma once

#include "gpu/handles.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace reliefbench::gpu {

/// Milliseconds between two ticks of a counter of which `valid_bits` count: the difference is taken in 64 bits, so
/// that a counter that wraps between them is no matter, and only then scaled, in double.
double elapsed_milliseconds(std::uint64_t start, std::uint64_t end, int valid_bits, double period_ns);

/// Pairs of timestamps around passes, for one submission. Both ends wait until everything before them is finished.
class Timestamps {
public:
    Timestamps(const Device& device, std::uint32_t intervals);

    /// Once per submission, before the first start, outside of rendering.
    void reset(const vk::raii::CommandBuffer& commands) const;
    void start(const vk::raii::CommandBuffer& commands, std::uint32_t interval) const;
    void end(const vk::raii::CommandBuffer& commands, std::uint32_t interval) const;

    /// After the submission has ended: milliseconds of each interval.
    std::vector<double> milliseconds() const;

private:
    void write(const vk::raii::CommandBuffer& commands, std::uint32_t query) const;

    const Device* device_;
    std::uint32_t intervals_;
    vk::raii::QueryPool pool_{nullptr};
};

/// Counters of one draw, by Vulkan's names in lower case with underscores: "fragment_shader_invocations".
class PipelineStatisticsQuery {
public:
    /// The device must have pipelineStatisticsQuery; tessellation counters only with `tessellation`.
    PipelineStatisticsQuery(const Device& device, bool tessellation);

    /// Outside of rendering.
    void start(const vk::raii::CommandBuffer& commands) const;
    void end(const vk::raii::CommandBuffer& commands) const;
    std::map<std::string, std::uint64_t> read() const;

private:
    const Device* device_;
    std::vector<std::string> names_;
    vk::raii::QueryPool pool_{nullptr};
};

}  // namespace reliefbench::gpu
