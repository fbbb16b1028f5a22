#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// The table at the end of a run: technique, parameters, view where it varies, ms (median ± MAD), ns per covered pixel,
/// taps per pixel, UV error, depth error, missed and false hits. Grouped by view, within a view sorted by error so that
/// quality is seen against cost; failed and skipped cells follow with their reasons.
std::string format_table(const std::vector<CellResult>& cells);

}  // namespace reliefbench
