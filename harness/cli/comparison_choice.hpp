#pragma once

#include "cli/quality_choice.hpp"
#include "compare/compare_runs.hpp"

#include <span>
#include <string>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
}

namespace reliefbench {

/// How stored runs are compared, as the command line says it.
struct ComparisonChoice {
    std::string threshold = "2%";
    bool across_devices = false;
    QualityChoice quality;

    void add_to(CLI::App& command);
    /// A threshold that is none is an Error, and so is what QualityChoice refuses.
    CompareOptions options(std::span<const StoredRun> runs) const;
};

}  // namespace reliefbench
