#pragma once

#include "store/cell_result.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

struct TableStyle {
    /// The widest line, unless a single word is wider.
    std::size_t columns = 100;
    /// ANSI colours: in each view the best third of a column is cyan, the worst third yellow, and marks are bold.
    bool colour = false;
};

/// The table at the end of a run: technique and parameters (those that differ from their defaults) and the columns of
/// quality_cost_table; where they leave names too little room, those that matter least are left out. Grouped by view,
/// within a view by ascending time, the values of an axis that moves no hits (self_shadow) below each other. `*` marks
/// the Pareto front of time and error (front_quality); cells whose missed and false hits exceed 0.5 % of the
/// footprint are kept off it and marked `!`. Failed and skipped cells follow, equal reasons together.
/// `record`: run.json's.
std::string format_table(const std::vector<CellResult>& cells, const TableStyle& style = {},
                         const Json& record = Json());

}  // namespace reliefbench
