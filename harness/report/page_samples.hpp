#pragma once

#include "report/sample_groups.hpp"
#include "store/cell_result.hpp"

#include <vector>

namespace reliefbench {

/// Samples as the report's page reads them, by pass in the order of their names: `[{"pass", "cell": [...], "groups":
/// [...], "first_round": [...], "samples": [...], "ms": [...]}, ...]`. `cell` and `groups` have one entry per cell with
/// samples of the pass: which of `cells` it is, and how many groups follow of it; `first_round` and `samples` have one
/// per group, and `ms` five: minimum, quartiles, maximum. A run of few cells keeps each round by itself, up to 64 of a
/// cell's pass; one of many puts consecutive rounds together, down to 2 groups, because the page's size must not grow
/// with the rounds.
Json samples_to_columns(const RunSamples& samples, const std::vector<CellResult>& cells);

}  // namespace reliefbench
