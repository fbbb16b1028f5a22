#pragma once

#include "compare/comparison.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// A comparison as the report's page reads it: comparison_to_json with `cells` as columns, of what the page shows only,
/// because an object for each of 100,000 cells is more than a browser takes: `{"cell": [...], "verdict", "ratio",
/// "low", "high", "visible", "reason", "quality": [...], "changes": [[place, [change, ...]], ...]}`. `cell` is a
/// position in `ids`, the cells of all runs of the page one after the other, among which every compared cell is;
/// `low` and `high` bound the 95 % interval; `quality` is the verdict; `changes` are `{"decides", "text"}` of the most
/// important dozen for better or worse, or of a deciding figure that one side lacks, the most important first, of the
/// places in the columns that have any. Numbers are rounded to six significant digits.
Json comparison_to_columns(const Comparison& comparison, const std::vector<std::string>& ids);

}  // namespace reliefbench
