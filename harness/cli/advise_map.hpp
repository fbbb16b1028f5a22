#pragma once

#include "cli/advise_request.hpp"
#include "cli/device_lock.hpp"
#include "cli/exit_code.hpp"
#include "cli/shared_options.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Advice from a height map: a sweep that the program chooses, narrowed while it measures.
struct AdviseMapOptions {
    std::string map;
    std::string albedo;
    std::string view_angles = "60,75";
    std::string resolution = "1280x720";
    double height_scale = 0.05;
    std::string time = "3m";
    std::string output;
    std::string pass_timeout = "10s";
    CellChoice cells;
    SamplingChoice sampling;
    TechniqueOptions library;
    DeviceChoice device;
    DeviceSharing sharing;
    PreparationOptions preparation;

    /// But --map.
    void add_to(CLI::App& command);
};

/// Says first what is wrong with the map; measures in a worker process, goes on where the run in the folder ended, and
/// prints the answer. `json`: instead of words.
ExitCode advise_from_map(const AdviseMapOptions& options, const AdviseRequestOptions& request, bool json,
                         const std::vector<std::string>& command_line);

}  // namespace reliefbench
