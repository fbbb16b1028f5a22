#pragma once

#include "report/ranking.hpp"
#include "store/figures.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// A cell's id is "<technique and parameters> | <view>".
std::pair<std::string, std::string> split_cell_id(const std::string& id);

struct QualityCostFigure {
    std::string text;
    /// Empty where it is undefined.
    std::optional<double> value;
};

struct QualityCostColumn {
    std::string title;
    const FigureDeclaration* figure = nullptr;
};

/// Quality against cost of one cell: what the table on the terminal and the one in Markdown show.
struct QualityCostRow {
    const CellResult* cell = nullptr;
    /// Technique and parameters.
    std::string setting;
    /// What of the cell's view moves no hit, where cells of the table differ in that ("self_shadow=hard"). Rows are
    /// ranked among those of their variant.
    std::string variant;
    /// '*' on the Pareto front of time and error (front_quality); '!' kept off it because missed and false hits exceed
    /// 0.5 % of the footprint; else ' '.
    char mark = ' ';
    /// One for each column.
    std::vector<QualityCostFigure> figures;
};

/// Cells that see the same hits.
struct QualityCostView {
    std::string view;
    std::vector<QualityCostRow> rows;
};

struct QualityCostTable {
    std::vector<QualityCostColumn> columns;
    std::vector<QualityCostView> views;
    /// Of the column of FLIP.
    RankingFlip flip = RankingFlip::footprint;
    int truth_samples = 1;
    /// What the marks say, a line each.
    std::vector<std::string> mark_legend;
    /// What the titles of all columns say, "uv: texels", whether or not a cell has the figure.
    std::vector<std::string> legend;
};

/// ms (median ± MAD of the draw), ns per covered pixel, taps per pixel, milliseconds of preparation, UV error in
/// texels, depth error, FLIP, missed and false hits; where a cell has them the mean error of its shadows and their taps
/// per pixel, and the mean change of the UV error in motion. The measured cells by view, in the order of the cells;
/// within a view by ascending time, then by id; the variants of one setting stand together at the place of its fastest,
/// in the order of the cells, so that what an axis costs and changes is seen at a glance. Refers to the cells.
/// `record`: run.json's.
QualityCostTable quality_cost_table(const std::vector<CellResult>& cells, const Json& record = Json());

/// Cells that failed or were skipped for one reason (MergedReason), in the order of their first. Refers to them.
struct ReasonGroup {
    std::string reason;
    std::vector<const CellResult*> cells;
};

std::vector<ReasonGroup> group_by_reason(const std::vector<CellResult>& cells, CellStatus status);

}  // namespace reliefbench
