#include "report/table.hpp"

#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace reliefbench {

namespace {

constexpr std::size_t terminal_columns = 140;
constexpr std::size_t space_between = 2;
/// Mark and a space.
constexpr std::size_t mark_columns = 2;
/// Missed and false hits above this fraction of the footprint: discarding hard pixels wins nothing.
constexpr double hit_limit = 0.005;
constexpr const char* draw_pass = "draw";
constexpr const char* undefined = "-";
/// Cells named under each reason for which cells failed or were skipped.
constexpr std::size_t cells_named = 3;

constexpr const char* legend =
    "* nothing in the view is both faster and better (UV p99)   "
    "! missed + false hits above 0.5 %: its errors do not count\n"
    "ms: median ± MAD of the draw; prep: making its maps; uv: texels; depth: patch sides; missed, false: % of the "
    "footprint\n";

struct Row {
    const CellResult* cell = nullptr;
    char mark = ' ';
    std::vector<std::string> columns;
};

struct Group {
    std::string view;
    std::vector<Row> rows;
};

/// A cell's id is "<technique and parameters> | <view>".
std::pair<std::string, std::string> split_id(const std::string& id) {
    constexpr std::string_view bar = " | ";
    const std::size_t at = id.find(bar);
    if (at == std::string::npos) return {id, ""};
    return {id.substr(0, at), id.substr(at + bar.size())};
}

std::optional<double> draw_ms(const CellResult& cell) {
    const auto draw = cell.time.find(draw_pass);
    if (draw == cell.time.end()) return std::nullopt;
    return draw->second.median_ms;
}

double sorting_ms(const CellResult& cell) {
    return draw_ms(cell).value_or(std::numeric_limits<double>::infinity());
}

bool hits_within_limit(const CellResult& cell) {
    return cell.error && cell.error->missed + cell.error->false_hits <= hit_limit;
}

/// What the Pareto front weighs against time; empty where there is nothing to rank by.
std::optional<double> quality(const CellResult& cell) {
    if (!hits_within_limit(cell) || !cell.error->uv_texels || !draw_ms(cell)) return std::nullopt;
    return cell.error->uv_texels->p99;
}

bool dominates(const CellResult& other, const CellResult& cell) {
    if (!quality(other)) return false;
    const double ms = *draw_ms(cell);
    const double other_ms = *draw_ms(other);
    return other_ms <= ms && *quality(other) <= *quality(cell) && (other_ms < ms || *quality(other) < *quality(cell));
}

char mark_of(const CellResult& cell, const std::vector<Row>& rows) {
    if (cell.error && !hits_within_limit(cell)) return '!';
    if (!quality(cell)) return ' ';
    const bool dominated =
        std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return dominates(*row.cell, cell); });
    return dominated ? ' ' : '*';
}

/// The median to four significant digits, the deviation to the same decimals.
std::string format_timing(const CellResult& cell) {
    const auto draw = cell.time.find(draw_pass);
    if (draw == cell.time.end()) return undefined;
    constexpr int digits = 4;
    const std::string ms = significant(draw->second.median_ms, digits);
    const std::size_t point = ms.find('.');
    if (ms.find('e') != std::string::npos) return ms + " ± " + significant(draw->second.mad_ms, 2);
    const std::size_t decimals = point == std::string::npos ? 0 : ms.size() - point - 1;
    return fmt::format("{} ± {:.{}f}", ms, draw->second.mad_ms, decimals);
}

std::string format_number(const std::optional<double>& value) {
    return value ? significant(*value) : undefined;
}

/// In the order of `titles`.
std::vector<std::string> format_columns(const CellResult& cell) {
    std::vector<std::string> columns = {format_timing(cell), format_number(cell.ns_per_pixel)};
    columns.push_back(cell.work ? significant(cell.work->taps_mean) : undefined);
    columns.push_back(format_number(cell.prepare_ms));
    const auto& error = cell.error;
    columns.push_back(error && error->uv_texels ? significant(error->uv_texels->p50) : undefined);
    columns.push_back(error && error->uv_texels ? significant(error->uv_texels->p99) : undefined);
    columns.push_back(error && error->depth ? significant(error->depth->p99) : undefined);
    columns.push_back(error ? significant(100 * error->missed) : undefined);
    columns.push_back(error ? significant(100 * error->false_hits) : undefined);
    return columns;
}

const std::vector<std::string> titles = {"ms",     "ns/pixel",  "taps",     "prep ms", "uv p50",
                                         "uv p99", "depth p99", "missed %", "false %"};

/// Views in the order of the cells; within a view by time, then by id.
std::vector<Group> group_by_view(const std::vector<CellResult>& cells) {
    std::vector<Group> groups;
    for (const CellResult& cell : cells) {
        if (cell.status != CellStatus::ok) continue;
        const std::string view = split_id(cell.cell).second;
        auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& each) { return each.view == view; });
        if (group == groups.end()) group = groups.insert(groups.end(), Group{view, {}});
        group->rows.push_back({&cell, ' ', format_columns(cell)});
    }
    for (Group& group : groups) {
        std::sort(group.rows.begin(), group.rows.end(), [](const Row& a, const Row& b) {
            return std::pair(sorting_ms(*a.cell), a.cell->cell) < std::pair(sorting_ms(*b.cell), b.cell->cell);
        });
        for (Row& row : group.rows) {
            row.mark = mark_of(*row.cell, group.rows);
        }
    }
    return groups;
}

/// One layout for all groups, so that columns can be compared from view to view.
class Layout {
public:
    explicit Layout(const std::vector<Group>& groups) {
        std::size_t longest_name = 0;
        for (const std::string& title : titles) {
            widths_.push_back(text_width(title));
        }
        for (const Group& group : groups) {
            for (const Row& row : group.rows) {
                longest_name = std::max(longest_name, text_width(split_id(row.cell->cell).first));
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

    std::string titles_line() const { return line(' ', "", titles); }

    std::string row_lines(const Row& row) const {
        const std::vector<std::string> name = wrap(split_id(row.cell->cell).first, name_width_);
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

std::string indented(std::string_view text, std::size_t indent) {
    std::string lines;
    for (const std::string& line : wrap(text, terminal_columns - indent)) {
        lines += std::string(indent, ' ') + line + '\n';
    }
    return lines;
}

/// Cells of one status, equal reasons together, in the order of their first cells.
std::string format_reasons(const std::vector<CellResult>& cells, CellStatus status, std::string_view word) {
    std::vector<std::pair<std::string, std::vector<std::string>>> reasons;
    for (const CellResult& cell : cells) {
        if (cell.status != status) continue;
        auto reason =
            std::find_if(reasons.begin(), reasons.end(), [&](const auto& each) { return each.first == cell.reason; });
        if (reason == reasons.end()) reason = reasons.insert(reasons.end(), {cell.reason, {}});
        reason->second.push_back(cell.cell);
    }
    std::string text;
    for (const auto& [reason, ids] : reasons) {
        text += indented(fmt::format("{}, {} {}: {}", word, ids.size(), ids.size() == 1 ? "cell" : "cells", reason), 0);
        for (std::size_t cell = 0; cell < std::min(ids.size(), cells_named); ++cell) {
            text += indented(ids[cell], 4);
        }
        if (ids.size() > cells_named) text += indented(fmt::format("and {} more", ids.size() - cells_named), 4);
    }
    return text;
}

}  // namespace

std::string format_table(const std::vector<CellResult>& cells) {
    const std::vector<Group> groups = group_by_view(cells);
    const Layout layout(groups);
    std::string text;
    for (const Group& group : groups) {
        text += indented(group.view, 0) + layout.titles_line();
        for (const Row& row : group.rows) {
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
