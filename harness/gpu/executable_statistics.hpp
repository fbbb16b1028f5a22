#pragma once

#include "gpu/pipeline.hpp"

#include <map>
#include <string>
#include <string_view>

namespace reliefbench::gpu {

/// What the driver tells of compiled stages, by stage ("fragment") and statistic ("register_count"): registers, spills,
/// bytes of code, by the driver's own names, normalised.
using ExecutableStatistics = std::map<std::string, std::map<std::string, double>>;

/// From a pipeline made for it, for a driver may make one whose statistics are captured differently; under "pipeline"
/// stands "compile_ms", how long making it took. Empty where the device lacks pipelineExecutableInfo.
ExecutableStatistics read_executable_statistics(const Device& device, GraphicsPipelineOptions options,
                                                const std::vector<Binding>& bindings);

/// "Register Count" becomes "register_count".
std::string normalized_statistic_name(std::string_view name);

}  // namespace reliefbench::gpu
