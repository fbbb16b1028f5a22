#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// A cell's id is "<technique and parameters> | <view>".
std::pair<std::string, std::string> split_cell_id(const std::string& id);

/// Quality against cost of one cell: what the table on the terminal and the one in Markdown show.
struct QualityCostRow {
    const CellResult* cell = nullptr;
    /// '*' on the Pareto front of time and 99th percentile of the UV error; '!' kept off it because missed and false
    /// hits exceed 0.5 % of the footprint; else ' '.
    char mark = ' ';
    /// One text per title.
    std::vector<std::string> columns;
};

struct QualityCostView {
    std::string view;
    std::vector<QualityCostRow> rows;
};

/// ms (median ± MAD of the draw), ns per covered pixel, taps per pixel, milliseconds of preparation, UV error in
/// texels, depth error, missed and false hits.
const std::vector<std::string>& quality_cost_titles();

/// The measured cells by view, in the order of the cells; within a view by ascending time, then by id. Refers to them.
std::vector<QualityCostView> quality_cost_views(const std::vector<CellResult>& cells);

/// Cells that failed or were skipped for the same reason, in the order of their first.
struct ReasonGroup {
    std::string reason;
    std::vector<std::string> cells;
};

std::vector<ReasonGroup> group_by_reason(const std::vector<CellResult>& cells, CellStatus status);

}  // namespace reliefbench
