#include "gpu/timers.hpp"

#include "gpu/commands.hpp"

#include <array>

namespace reliefbench::gpu {

namespace {

struct Statistic {
    vk::QueryPipelineStatisticFlagBits bit;
    const char* name;
    bool tessellation;
};

/// In the order of their bits, which is the order of the results.
using Bits = vk::QueryPipelineStatisticFlagBits;
constexpr std::array statistics{
    Statistic{Bits::eInputAssemblyVertices, "input_assembly_vertices", false},
    Statistic{Bits::eInputAssemblyPrimitives, "input_assembly_primitives", false},
    Statistic{Bits::eVertexShaderInvocations, "vertex_shader_invocations", false},
    Statistic{Bits::eClippingInvocations, "clipping_invocations", false},
    Statistic{Bits::eClippingPrimitives, "clipping_primitives", false},
    Statistic{Bits::eFragmentShaderInvocations, "fragment_shader_invocations", false},
    Statistic{Bits::eTessellationControlShaderPatches, "tessellation_control_shader_patches", true},
    Statistic{Bits::eTessellationEvaluationShaderInvocations, "tessellation_evaluation_shader_invocations", true},
};

std::vector<std::uint64_t> read_queries(const vk::raii::QueryPool& pool, std::uint32_t queries,
                                        std::size_t values_per_query) {
    const std::size_t values = queries * values_per_query;
    const auto [result, data] = pool.getResults<std::uint64_t>(
        0, queries, values * sizeof(std::uint64_t), values_per_query * sizeof(std::uint64_t),
        vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    if (result != vk::Result::eSuccess) fail("reading queries gave {}", vk::to_string(result));
    return data;
}

}  // namespace

double elapsed_milliseconds(std::uint64_t start, std::uint64_t end, int valid_bits, double period_ns) {
    constexpr double nanoseconds_per_millisecond = 1e6;
    const std::uint64_t mask = valid_bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << valid_bits) - 1;
    return static_cast<double>((end - start) & mask) * period_ns / nanoseconds_per_millisecond;
}

Timestamps::Timestamps(const Device& device, std::uint32_t intervals) : device_(&device), intervals_(intervals) {
    translate_errors("make timestamp queries", device.info().name, [&] {
        pool_ = vk::raii::QueryPool(
            device.handles().device,
            vk::QueryPoolCreateInfo{.queryType = vk::QueryType::eTimestamp, .queryCount = 2 * intervals});
    });
}

void Timestamps::reset(const vk::raii::CommandBuffer& commands) const {
    commands.resetQueryPool(*pool_, 0, 2 * intervals_);
}

void Timestamps::start(const vk::raii::CommandBuffer& commands, std::uint32_t interval) const {
    write(commands, 2 * interval);
}

void Timestamps::end(const vk::raii::CommandBuffer& commands, std::uint32_t interval) const {
    write(commands, 2 * interval + 1);
}

void Timestamps::write(const vk::raii::CommandBuffer& commands, std::uint32_t query) const {
    full_barrier(commands);
    commands.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *pool_, query);
    // lavapipe bins a timestamp with the draw that follows and takes it tile by tile, so that the last tile of that
    // draw would decide it; a barrier makes it take the timestamp now. Elsewhere, with nothing running, it costs
    // little.
    full_barrier(commands);
}

std::vector<double> Timestamps::milliseconds() const {
    const DeviceInfo& info = device_->info();
    return translate_errors("read timestamps", info.name, [&] {
        const std::vector<std::uint64_t> ticks = read_queries(pool_, 2 * intervals_, 1);
        std::vector<double> result;
        for (std::size_t i = 0; i < intervals_; ++i)
            result.push_back(elapsed_milliseconds(ticks[2 * i], ticks[2 * i + 1], info.timestamp_valid_bits,
                                                  info.timestamp_period_ns));
        return result;
    });
}

PipelineStatisticsQuery::PipelineStatisticsQuery(const Device& device, bool tessellation) : device_(&device) {
    vk::QueryPipelineStatisticFlags counted;
    for (const Statistic& statistic : statistics) {
        if (statistic.tessellation && !tessellation) continue;
        counted |= statistic.bit;
        names_.emplace_back(statistic.name);
    }
    translate_errors("make pipeline statistics queries", device.info().name, [&] {
        pool_ = vk::raii::QueryPool(
            device.handles().device,
            vk::QueryPoolCreateInfo{
                .queryType = vk::QueryType::ePipelineStatistics, .queryCount = 1, .pipelineStatistics = counted});
    });
}

void PipelineStatisticsQuery::start(const vk::raii::CommandBuffer& commands) const {
    commands.resetQueryPool(*pool_, 0, 1);
    commands.beginQuery(*pool_, 0, {});
}

void PipelineStatisticsQuery::end(const vk::raii::CommandBuffer& commands) const {
    commands.endQuery(*pool_, 0);
}

std::map<std::string, std::uint64_t> PipelineStatisticsQuery::read() const {
    return translate_errors("read pipeline statistics", device_->info().name, [&] {
        const std::vector<std::uint64_t> values = read_queries(pool_, 1, names_.size());
        std::map<std::string, std::uint64_t> result;
        for (std::size_t i = 0; i < names_.size(); ++i)
            result[names_[i]] = values[i];
        return result;
    });
}

}  // namespace reliefbench::gpu
