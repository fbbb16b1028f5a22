#include "report/table.hpp"

#include "report/quality_cost.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace reliefbench {

namespace {

constexpr std::size_t terminal_columns = 140;
constexpr std::size_t space_between = 2;
/// Mark and a space.
constexpr std::size_t mark_columns = 2;
/// Cells named under each reason for which cells failed or were skipped.
constexpr std::size_t cells_named = 3;

constexpr const char* legend =
    "* nothing in the view is both faster and better (UV p99)   "
    "! missed + false hits above 0.5 %: its errors do not count\n"
    "ms: median ± MAD of the draw; prep: making its maps; uv: texels; depth: patch sides; missed, false: % of the "
    "footprint\n";

/// One layout for all groups, so that columns can be compared from view to view.
class Layout {
public:
    explicit Layout(const std::vector<QualityCostView>& groups) {
        std::size_t longest_name = 0;
        for (const std::string& title : quality_cost_titles()) {
            widths_.push_back(text_width(title));
        }
        for (const QualityCostView& group : groups) {
            for (const QualityCostRow& row : group.rows) {
                longest_name = std::max(longest_name, text_width(split_cell_id(row.cell->cell).first));
                for (std::size_t column = 0; column < widths_.size(); ++column) {
                    widths_[column] = std::max(widths_[column], text_width(row.columns[column]));
                }
            }
        }
        std::size_t taken = mark_columns;
        for (const std::size_t width : widths_) {
            taken += space_between + width;
        }
        name_width_ = std::min(longest_name, terminal_columns - std::min(terminal_columns, taken));
    }

    std::string titles_line() const { return line(' ', "", quality_cost_titles()); }

    std::string row_lines(const QualityCostRow& row) const {
        const std::vector<std::string> name = wrap(split_cell_id(row.cell->cell).first, name_width_);
        std::string lines = line(row.mark, name.front(), row.columns);
        for (std::size_t rest = 1; rest < name.size(); ++rest) {
            lines += std::string(mark_columns, ' ') + name[rest] + '\n';
        }
        return lines;
    }

private:
    std::string line(char mark, const std::string& name, const std::vector<std::string>& columns) const {
        std::string text = fmt::format("{} {}", mark, pad_right(name, name_width_));
        for (std::size_t column = 0; column < widths_.size(); ++column) {
            text += std::string(space_between, ' ') + pad_left(columns[column], widths_[column]);
        }
        return text + '\n';
    }

    std::vector<std::size_t> widths_;
    std::size_t name_width_ = 0;
};

/// Cells of one status, equal reasons together.
std::string format_reasons(const std::vector<CellResult>& cells, CellStatus status, std::string_view word) {
    std::string text;
    for (const auto& [reason, ids] : group_by_reason(cells, status)) {
        text += indented(fmt::format("{}, {}: {}", word, counted(ids.size(), "cell"), reason), 0, terminal_columns);
        for (std::size_t cell = 0; cell < std::min(ids.size(), cells_named); ++cell) {
            text += indented(ids[cell], 4, terminal_columns);
        }
        if (ids.size() > cells_named)
            text += indented(fmt::format("and {} more", ids.size() - cells_named), 4, terminal_columns);
    }
    return text;
}

}  // namespace

std::string format_table(const std::vector<CellResult>& cells) {
    const std::vector<QualityCostView> groups = quality_cost_views(cells);
    const Layout layout(groups);
    std::string text;
    for (const QualityCostView& group : groups) {
        text += indented(group.view, 0, terminal_columns) + layout.titles_line();
        for (const QualityCostRow& row : group.rows) {
            text += layout.row_lines(row);
        }
        text += '\n';
    }
    if (!groups.empty()) text += legend;
    const std::string reasons =
        format_reasons(cells, CellStatus::failed, "failed") + format_reasons(cells, CellStatus::skipped, "skipped");
    if (!text.empty() && !reasons.empty()) text += '\n';
    return text + reasons;
}

}  // namespace reliefbench
