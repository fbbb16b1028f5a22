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

QualityCostFigure figure(const std::optional<double>& value) {
    return {value ? significant(*value) : undefined, value};
}

/// A member of what may be missing altogether.
template <typename Fields>
std::optional<double> member(const std::optional<Fields>& fields, double Fields::*value) {
    if (!fields) return std::nullopt;
    return (*fields).*value;
}

std::optional<double> percent(const std::optional<double>& fraction) {
    if (!fraction) return std::nullopt;
    return 100 * *fraction;
}

const std::vector<QualityCostColumn>& columns_of_all() {
    static const std::vector<QualityCostColumn> columns = {
        {"ms", false},    {"ns/pixel", false}, {"taps", false}, {"prep ms", false}, {"uv p50", true},
        {"uv p99", true}, {"depth p99", true}, {"flip", true},  {"missed %", true}, {"false %", true}};
    return columns;
}

/// In the order of the columns.
std::vector<QualityCostFigure> figures_of(const CellResult& cell, bool with_motion) {
    using Errors = CellResult::Errors;
    const Errors error = cell.error.value_or(Errors());
    std::vector<QualityCostFigure> figures = {{format_timing(cell), draw_ms(cell)},
                                              figure(cell.ns_per_pixel),
                                              figure(member(cell.work, &CellResult::Work::taps_mean)),
                                              figure(cell.prepare_ms),
                                              figure(member(error.uv_texels, &Summary::p50)),
                                              figure(member(error.uv_texels, &Summary::p99)),
                                              figure(member(error.depth, &Summary::p99)),
                                              figure(cell.image ? cell.image->flip : std::nullopt),
                                              figure(percent(member(cell.error, &Errors::missed))),
                                              figure(percent(member(cell.error, &Errors::false_hits)))};
    if (with_motion) {
        const auto motion = cell.motion ? cell.motion->texels : std::nullopt;
        figures.push_back(figure(member(motion, &CellResult::MotionFigure::mean)));
    }
    return figures;
}

}  // namespace

std::pair<std::string, std::string> split_cell_id(const std::string& id) {
    constexpr std::string_view bar = " | ";
    const std::size_t at = id.find(bar);
    if (at == std::string::npos) return {id, ""};
    return {id.substr(0, at), id.substr(at + bar.size())};
}

QualityCostTable quality_cost_table(const std::vector<CellResult>& cells) {
    QualityCostTable table{.columns = columns_of_all(), .views = {}};
    const bool with_motion =
        std::any_of(cells.begin(), cells.end(), [](const CellResult& cell) { return cell.motion.has_value(); });
    if (with_motion) table.columns.push_back({"motion", true});
    for (const CellResult& cell : cells) {
        if (cell.status != CellStatus::ok) continue;
        const std::string view = split_cell_id(cell.cell).second;
        auto group = std::find_if(table.views.begin(), table.views.end(),
                                  [&](const QualityCostView& each) { return each.view == view; });
        if (group == table.views.end()) group = table.views.insert(table.views.end(), QualityCostView{view, {}});
        group->rows.push_back({&cell, ' ', figures_of(cell, with_motion)});
    }
    for (QualityCostView& group : table.views) {
        std::sort(group.rows.begin(), group.rows.end(), [](const QualityCostRow& a, const QualityCostRow& b) {
            return std::pair(sorting_ms(*a.cell), a.cell->cell) < std::pair(sorting_ms(*b.cell), b.cell->cell);
        });
        for (QualityCostRow& row : group.rows) {
            row.mark = mark_of(*row.cell, group.rows);
        }
    }
    return table;
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
