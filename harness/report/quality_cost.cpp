#include "report/quality_cost.hpp"

#include "report/merged_reason.hpp"
#include "report/text_layout.hpp"
#include "store/view_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

namespace reliefbench {

namespace {

constexpr const char* undefined = "-";

std::optional<double> draw_ms(const CellResult& cell) {
    const PassTiming* const draw = draw_timing(cell);
    if (draw == nullptr) return std::nullopt;
    return draw->median_ms;
}

double sorting_ms(const CellResult& cell) {
    return draw_ms(cell).value_or(std::numeric_limits<double>::infinity());
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

char mark_of(const QualityCostRow& row, const std::vector<QualityCostRow>& rows) {
    const CellResult& cell = *row.cell;
    if (cell.error && !hits_within_limit(cell)) return '!';
    if (!quality(cell)) return ' ';
    const bool dominated = std::any_of(rows.begin(), rows.end(), [&](const QualityCostRow& other) {
        return other.variant == row.variant && dominates(*other.cell, cell);
    });
    return dominated ? ' ' : '*';
}

/// The median to four significant digits, the deviation to the same decimals.
std::string format_timing(const CellResult& cell) {
    const PassTiming* const draw = draw_timing(cell);
    if (draw == nullptr) return undefined;
    constexpr int digits = 4;
    const std::string ms = significant(draw->median_ms, digits);
    const std::size_t point = ms.find('.');
    if (ms.find('e') != std::string::npos) return ms + " ± " + significant(draw->mad_ms, 2);
    const std::size_t decimals = point == std::string::npos ? 0 : ms.size() - point - 1;
    return fmt::format("{} ± {:.{}f}", ms, draw->mad_ms, decimals);
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

/// Figures that only some runs have.
struct OptionalColumns {
    bool shadow = false;
    bool motion = false;
};

OptionalColumns optional_columns(const std::vector<CellResult>& cells) {
    OptionalColumns columns;
    for (const CellResult& cell : cells) {
        columns.shadow = columns.shadow || (cell.error && cell.error->shadow);
        columns.motion = columns.motion || cell.motion;
    }
    return columns;
}

std::vector<QualityCostColumn> columns_of(const OptionalColumns& with) {
    std::vector<QualityCostColumn> columns = {
        {"ms", false},    {"ns/pixel", false}, {"taps", false}, {"prep ms", false}, {"uv p50", true},
        {"uv p99", true}, {"depth p99", true}, {"flip", true},  {"missed %", true}, {"false %", true}};
    if (with.shadow) columns.insert(columns.end(), {{"shadow taps", false}, {"shadow", true}});
    if (with.motion) columns.push_back({"motion", true});
    return columns;
}

/// In the order of the columns.
std::vector<QualityCostFigure> figures_of(const CellResult& cell, RankingFlip flip, const OptionalColumns& with) {
    using Errors = CellResult::Errors;
    const Errors error = cell.error.value_or(Errors());
    std::vector<QualityCostFigure> figures = {{format_timing(cell), draw_ms(cell)},
                                              figure(cell.ns_per_pixel),
                                              figure(member(cell.work, &CellResult::Work::taps_mean)),
                                              figure(cell.prepare_ms),
                                              figure(member(error.uv_texels, &Summary::p50)),
                                              figure(member(error.uv_texels, &Summary::p99)),
                                              figure(member(error.depth, &Summary::p99)),
                                              figure(flip_of(cell, flip)),
                                              figure(percent(member(cell.error, &Errors::missed))),
                                              figure(percent(member(cell.error, &Errors::false_hits)))};
    if (with.shadow) {
        figures.push_back(figure(cell.work ? cell.work->shadow_taps_mean : std::nullopt));
        figures.push_back(figure(member(error.shadow, &CellResult::ShadowErrors::mean)));
    }
    if (with.motion) {
        const auto motion = cell.motion ? cell.motion->texels : std::nullopt;
        figures.push_back(figure(member(motion, &CellResult::MotionFigure::mean)));
    }
    return figures;
}

QualityCostView& view_of(std::vector<QualityCostView>& views, const std::string& view) {
    const auto known =
        std::find_if(views.begin(), views.end(), [&](const QualityCostView& each) { return each.view == view; });
    return known != views.end() ? *known : views.emplace_back(QualityCostView{view, {}});
}

/// By the time of the fastest of each setting's variants; these in the order in which they are.
void sort_rows(std::vector<QualityCostRow>& rows) {
    std::map<std::string, double> fastest;
    for (const QualityCostRow& row : rows) {
        const auto [setting, is_new] = fastest.try_emplace(row.setting, sorting_ms(*row.cell));
        if (!is_new) setting->second = std::min(setting->second, sorting_ms(*row.cell));
    }
    std::stable_sort(rows.begin(), rows.end(), [&](const QualityCostRow& a, const QualityCostRow& b) {
        return std::pair(fastest.at(a.setting), a.setting) < std::pair(fastest.at(b.setting), b.setting);
    });
}

}  // namespace

std::pair<std::string, std::string> split_cell_id(const std::string& id) {
    constexpr std::string_view bar = " | ";
    const std::size_t at = id.find(bar);
    if (at == std::string::npos) return {id, ""};
    return {id.substr(0, at), id.substr(at + bar.size())};
}

QualityCostTable quality_cost_table(const std::vector<CellResult>& cells) {
    const OptionalColumns with = optional_columns(cells);
    QualityCostTable table{.columns = columns_of(with), .views = {}, .flip = ranking_flip(cells)};
    const std::vector<ViewVariant> variants = view_variants(cells);
    for (std::size_t at = 0; at < cells.size(); ++at) {
        const CellResult& cell = cells[at];
        if (cell.status != CellStatus::ok) continue;
        const auto& [view, variant] = variants[at];
        view_of(table.views, view)
            .rows.push_back({.cell = &cell,
                             .setting = split_cell_id(cell.cell).first,
                             .variant = variant,
                             .figures = figures_of(cell, table.flip, with)});
    }
    for (QualityCostView& view : table.views) {
        sort_rows(view.rows);
        for (QualityCostRow& row : view.rows) {
            row.mark = mark_of(row, view.rows);
        }
    }
    return table;
}

std::vector<ReasonGroup> group_by_reason(const std::vector<CellResult>& cells, CellStatus status) {
    std::vector<ReasonGroup> groups;
    std::vector<MergedReason> reasons;
    for (const CellResult& cell : cells) {
        if (cell.status != status) continue;
        const auto joined = std::ranges::find_if(reasons, [&](MergedReason& each) { return each.add(cell.reason); });
        const auto group = static_cast<std::size_t>(joined - reasons.begin());
        if (joined == reasons.end()) {
            reasons.emplace_back(cell.reason);
            groups.emplace_back();
        }
        groups[group].cells.push_back(&cell);
    }
    for (std::size_t group = 0; group < groups.size(); ++group)
        groups[group].reason = reasons[group].text();
    return groups;
}

}  // namespace reliefbench
