#include "report/quality_cost.hpp"

#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>

namespace reliefbench {

namespace {

/// Missed and false hits above this fraction of the footprint: discarding hard pixels wins nothing.
constexpr double hit_limit = 0.005;
constexpr const char* draw_pass = "draw";
constexpr const char* undefined = "-";

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

char mark_of(const CellResult& cell, const std::vector<QualityCostRow>& rows) {
    if (cell.error && !hits_within_limit(cell)) return '!';
    if (!quality(cell)) return ' ';
    const bool dominated =
        std::any_of(rows.begin(), rows.end(), [&](const QualityCostRow& row) { return dominates(*row.cell, cell); });
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

/// In the order of the titles.
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

}  // namespace

std::pair<std::string, std::string> split_cell_id(const std::string& id) {
    constexpr std::string_view bar = " | ";
    const std::size_t at = id.find(bar);
    if (at == std::string::npos) return {id, ""};
    return {id.substr(0, at), id.substr(at + bar.size())};
}

const std::vector<std::string>& quality_cost_titles() {
    static const std::vector<std::string> titles = {"ms",     "ns/pixel",  "taps",     "prep ms", "uv p50",
                                                    "uv p99", "depth p99", "missed %", "false %"};
    return titles;
}

std::vector<QualityCostView> quality_cost_views(const std::vector<CellResult>& cells) {
    std::vector<QualityCostView> groups;
    for (const CellResult& cell : cells) {
        if (cell.status != CellStatus::ok) continue;
        const std::string view = split_cell_id(cell.cell).second;
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const QualityCostView& each) { return each.view == view; });
        if (group == groups.end()) group = groups.insert(groups.end(), QualityCostView{view, {}});
        group->rows.push_back({&cell, ' ', format_columns(cell)});
    }
    for (QualityCostView& group : groups) {
        std::sort(group.rows.begin(), group.rows.end(), [](const QualityCostRow& a, const QualityCostRow& b) {
            return std::pair(sorting_ms(*a.cell), a.cell->cell) < std::pair(sorting_ms(*b.cell), b.cell->cell);
        });
        for (QualityCostRow& row : group.rows) {
            row.mark = mark_of(*row.cell, group.rows);
        }
    }
    return groups;
}

std::vector<ReasonGroup> group_by_reason(const std::vector<CellResult>& cells, CellStatus status) {
    std::vector<ReasonGroup> groups;
    for (const CellResult& cell : cells) {
        if (cell.status != status) continue;
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const ReasonGroup& each) { return each.reason == cell.reason; });
        if (group == groups.end()) group = groups.insert(groups.end(), ReasonGroup{cell.reason, {}});
        group->cells.push_back(cell.cell);
    }
    return groups;
}

}  // namespace reliefbench
