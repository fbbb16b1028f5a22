#pragma once

#include "compare/compare_runs.hpp"

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

    void add_to(CLI::App& command);
    /// A threshold that is none is an Error.
    CompareOptions options() const;
};

}  // namespace reliefbench
