#pragma once

#include "cli/configuration_text.hpp"
#include "cli/shared_options.hpp"
#include "sweep/configuration.hpp"
#include "sweep/shard.hpp"
#include "technique/technique.hpp"

#include <optional>
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
    /// The shard that an earlier run was.
    std::optional<Shard> shard;
};

/// Of a configuration, or of a run.json, whose filters, technique directories and shard are then taken over.
RunSources read_run_sources(const ConfigurationText& text, const CellChoice& choice,
                            const TechniqueOptions& techniques);

}  // namespace reliefbench
