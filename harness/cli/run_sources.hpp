#pragma once

#include "cli/shared_options.hpp"
#include "sweep/configuration.hpp"
#include "technique/technique.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Everything a run is made from, read and checked; no device and no height map is touched.
struct RunSources {
    Configuration configuration;
    TechniqueLibrary library;
    std::vector<Cell> cells;
    /// As given, and as an earlier run had them when its run.json is what is run.
    std::vector<std::string> filters;
    std::vector<std::string> technique_directories;
};

/// `path` is a configuration or a run.json, whose filters and technique directories are then taken over.
RunSources read_run_sources(const std::string& path, const std::vector<std::string>& axes,
                            const std::vector<std::string>& filters, const TechniqueOptions& techniques);

}  // namespace reliefbench
