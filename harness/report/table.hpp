#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// The table at the end of a run, at most 140 columns wide: technique and parameters (those that differ from their
/// defaults), ms (median ± MAD of the draw), ns per covered pixel, taps per pixel, milliseconds of preparation, UV
/// error in texels, depth error, missed and false hits. Grouped by view, within a view by ascending time. `*` marks the
/// Pareto front of time and 99th percentile of the UV error; cells whose missed and false hits exceed 0.5 % of the
/// footprint are kept off it and marked `!`. Failed and skipped cells follow, equal reasons together.
std::string format_table(const std::vector<CellResult>& cells);

}  // namespace reliefbench
