#include "gpu/executable_statistics.hpp"

#include <array>
#include <cctype>
#include <utility>

namespace reliefbench::gpu {

namespace {

using Stage = vk::ShaderStageFlagBits;

constexpr std::array<std::pair<Stage, const char*>, 4> stage_names{{
    {Stage::eVertex, "vertex"},
    {Stage::eTessellationControl, "tessellation_control"},
    {Stage::eTessellationEvaluation, "tessellation_evaluation"},
    {Stage::eFragment, "fragment"},
}};

/// Drivers may compile several stages into one executable.
std::string name_of(vk::ShaderStageFlags stages) {
    std::string name;
    for (const auto& [stage, stage_name] : stage_names) {
        if (stages & stage) name += (name.empty() ? "" : "_") + std::string(stage_name);
    }
    return name.empty() ? "other" : name;
}

double value_of(const vk::PipelineExecutableStatisticKHR& statistic) {
    switch (statistic.format) {
        case vk::PipelineExecutableStatisticFormatKHR::eBool32:
            return statistic.value.b32 != 0 ? 1 : 0;
        case vk::PipelineExecutableStatisticFormatKHR::eInt64:
            return static_cast<double>(statistic.value.i64);
        case vk::PipelineExecutableStatisticFormatKHR::eUint64:
            return static_cast<double>(statistic.value.u64);
        case vk::PipelineExecutableStatisticFormatKHR::eFloat64:
            return statistic.value.f64;
    }
    return 0;
}

}  // namespace

std::string normalized_statistic_name(std::string_view name) {
    std::string result;
    bool between_words = false;
    for (const char character : name) {
        const auto letter = static_cast<unsigned char>(character);
        if (std::isalnum(letter) == 0) {
            between_words = !result.empty();
            continue;
        }
        if (between_words) result += '_';
        between_words = false;
        result += static_cast<char>(std::tolower(letter));
    }
    return result;
}

ExecutableStatistics read_executable_statistics(const Device& device, GraphicsPipelineOptions options,
                                                const std::vector<Binding>& bindings) {
    const DeviceInfo& info = device.info();
    if (!info.has_feature(pipeline_executable_feature)) return {};
    options.flags = vk::PipelineCreateFlagBits::eCaptureStatisticsKHR;
    const Pipeline pipeline = make_graphics_pipeline(device, options, bindings);
    return translate_errors("read the statistics of a pipeline", info.name, [&] {
        const vk::raii::Device& vulkan = device.handles().device;
        ExecutableStatistics result;
        result["pipeline"]["compile_ms"] = pipeline.shared->made_in_ms;
        const auto executables = vulkan.getPipelineExecutablePropertiesKHR({.pipeline = *pipeline.shared->pipeline});
        for (std::uint32_t index = 0; index < executables.size(); ++index) {
            // Two executables of one stage, of different widths perhaps, go by their own names.
            std::string stage = name_of(executables[index].stages);
            if (result.contains(stage)) stage += "_" + normalized_statistic_name(executables[index].name.data());
            const auto statistics = vulkan.getPipelineExecutableStatisticsKHR(
                {.pipeline = *pipeline.shared->pipeline, .executableIndex = index});
            for (const vk::PipelineExecutableStatisticKHR& statistic : statistics)
                result[stage][normalized_statistic_name(statistic.name.data())] = value_of(statistic);
        }
        return result;
    });
}

}  // namespace reliefbench::gpu
