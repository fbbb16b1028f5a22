#pragma once

#include "store/run_folder.hpp"

#include <span>
#include <string>
#include <vector>

namespace reliefbench {

/// A run and how messages call it.
struct NamedRun {
    std::string name;
    Run run;
};

/// A cell that the run's configuration has, and the shard that it belongs to, from 1.
struct PlannedCell {
    std::string cell;
    std::size_t shard = 1;
};

/// Shards of one run put together.
struct MergedRun {
    Run run;
    /// What is missing, in words: shards that were not given, and cells of those that were. Empty when the run is
    /// whole.
    std::vector<std::string> missing;
};

/// Puts shards of one run together (run.json `shard`). They must have the same configuration, filters, sources of
/// techniques and shaders, content of height maps, device and driver (for a CPU device the CPU), so that no statistic
/// ever mixes devices: else an Error that says what differs. So is a shard, or a cell, that stands in two of them.
/// Which cells are missing is known where `planned` lists all of the run's. run.json is the first shard's without what
/// is its own; its `merged` lists every shard: its name, `shard`, `environment`, `device` and `cells`, so that each
/// cell's machine is known. Cells are in the order of the shards given.
MergedRun merge_runs(std::vector<NamedRun> shards, std::span<const PlannedCell> planned = {});

}  // namespace reliefbench
