#pragma once

#include "sweep/shard.hpp"

#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// Which part of a sweep to measure, empty for all of it: what --shard says (`option`); else what the run.json that is
/// repeated was (`recorded`); else the task of a Slurm job array (SLURM_ARRAY_TASK_ID, counted from
/// SLURM_ARRAY_TASK_MIN, of SLURM_ARRAY_TASK_COUNT); else GTEST_SHARD_INDEX (from 0) of GTEST_TOTAL_SHARDS. A value
/// that is no shard is an Error that names where it stands.
std::optional<Shard> chosen_shard(const std::string& option, const std::optional<Shard>& recorded);

/// cells_of_shard; one that gets nothing to measure is a warning.
std::vector<Cell> take_shard(const std::vector<Cell>& cells, Shard shard);

}  // namespace reliefbench
