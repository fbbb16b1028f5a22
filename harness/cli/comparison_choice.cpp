#include "cli/comparison_choice.hpp"

#include "cli/threshold.hpp"

#include <CLI/CLI.hpp>

namespace reliefbench {

void ComparisonChoice::add_to(CLI::App& command) {
    command
        .add_option("--threshold", threshold,
                    "The smallest change of time that matters, written 2% or 0.02; default: 2%")
        ->type_name("FRACTION");
    command.add_flag("--across-devices", across_devices,
                     "Compare runs of different devices, whose times say nothing of a change in code");
    quality.add_to(command);
}

CompareOptions ComparisonChoice::options(std::span<const StoredRun> runs) const {
    CompareOptions options;
    options.threshold = parse_threshold(threshold, "--threshold");
    options.across_devices = across_devices;
    options.deciding_figures = quality.deciding_figures(runs);
    return options;
}

}  // namespace reliefbench
