#include "report/quality_cost.hpp"

#include "core/suggest.hpp"
#include "report/figure_text.hpp"
#include "report/merged_reason.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"
#include "store/view_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

namespace reliefbench {

namespace {

/// What the Pareto front weighs against each other.
const FigureDeclaration& front_cost() {
    static const FigureDeclaration& figure = known_figure(chosen_figures::cost);
    return figure;
}

double sorting_ms(const CellResult& cell) {
    return value_of(front_cost(), cell).value_or(std::numeric_limits<double>::infinity());
}

/// Whether the cell takes part in the front.
bool is_ranked(const CellResult& cell, const FigureDeclaration& quality) {
    return hits_within_limit(cell) && value_of(quality, cell) && value_of(front_cost(), cell);
}

/// Both are ranked.
bool dominates(const CellResult& other, const CellResult& cell, const FigureDeclaration& quality) {
    bool better = false;
    for (const FigureDeclaration* figure : {&front_cost(), &quality}) {
        const double theirs = *value_of(*figure, other);
        const double its_own = *value_of(*figure, cell);
        if (is_better(its_own, theirs, figure->better)) return false;
        better = better || is_better(theirs, its_own, figure->better);
    }
    return better;
}

char mark_of(const QualityCostRow& row, const std::vector<QualityCostRow>& rows, const FigureDeclaration& quality) {
    const CellResult& cell = *row.cell;
    if (wrong_hits(cell) && !hits_within_limit(cell)) return '!';
    if (!is_ranked(cell, quality)) return ' ';
    const bool dominated = std::any_of(rows.begin(), rows.end(), [&](const QualityCostRow& other) {
        return other.variant == row.variant && is_ranked(*other.cell, quality) && dominates(*other.cell, cell, quality);
    });
    return dominated ? ' ' : '*';
}

/// Of both marks.
std::vector<std::string> mark_legend(const FigureDeclaration& quality) {
    return {fmt::format("* nothing in the view is both faster and better ({})", column_title(quality)),
            "! missed + false hits above 0.5 %: its errors do not count"};
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

struct TableColumn {
    std::string_view figure;
    /// Only where a cell has it.
    bool is_optional = false;
};

std::vector<TableColumn> all_columns(RankingFlip flip) {
    using namespace chosen_figures;
    return {{cost},          {ns_per_pixel}, {taps},       {preparation},       {median_uv},    {quality},     {depth},
            {path_of(flip)}, {missed},       {false_hits}, {shadow_taps, true}, {shadow, true}, {motion, true}};
}

std::vector<QualityCostColumn> columns_of(RankingFlip flip, const std::vector<CellResult>& cells) {
    std::vector<QualityCostColumn> columns;
    for (const TableColumn& column : all_columns(flip)) {
        const FigureDeclaration& figure = known_figure(column.figure);
        const bool is_shown =
            !column.is_optional ||
            std::any_of(cells.begin(), cells.end(), [&](const CellResult& cell) { return value_of(figure, cell); });
        if (is_shown) columns.push_back({column_title(figure), &figure});
    }
    return columns;
}

/// What short names and units leave unsaid; those that say the same stand together ("missed, false: % of footprint").
std::vector<std::string> legend_of(RankingFlip flip, int truth_samples) {
    struct Entry {
        std::vector<std::string> names;
        std::string meaning;
    };
    std::vector<Entry> entries;
    for (const TableColumn& column : all_columns(flip)) {
        const FigureDeclaration& figure = known_figure(column.figure);
        const std::string unit = figure_unit_text(figure.unit);
        std::string meaning = !figure.legend.empty() ? figure.legend : unit.substr(unit.empty() ? 0 : 1);
        if (meaning.empty()) continue;
        if (&figure == &front_cost()) meaning += " ± MAD";
        if (truth_samples > 1 && column.figure == path_of(flip))
            meaning += fmt::format(", against a truth of {} samples a pixel", truth_samples);
        const std::string name = figure.short_label.substr(0, figure.short_label.find(' '));
        if (entries.empty() || entries.back().meaning != meaning) entries.push_back({{}, meaning});
        std::vector<std::string>& names = entries.back().names;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::vector<std::string> legend;
    for (const Entry& entry : entries)
        legend.push_back(fmt::format("{}: {}", join(entry.names), entry.meaning));
    return legend;
}

/// Fractions per cent.
QualityCostFigure figure_of(const FigureDeclaration& figure, const CellResult& cell) {
    std::optional<double> value = value_of(figure, cell);
    if (!value) return {undefined, value};
    value = figure_as_shown(*value, figure.unit);
    return {&figure == &front_cost() ? format_timing(cell) : significant(*value), value};
}

std::vector<QualityCostFigure> figures_of(const CellResult& cell, const std::vector<QualityCostColumn>& columns) {
    std::vector<QualityCostFigure> figures;
    for (const QualityCostColumn& column : columns) {
        figures.push_back(figure_of(*column.figure, cell));
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

QualityCostTable quality_cost_table(const std::vector<CellResult>& cells, const Json& record) {
    const RankingFlip flip = ranking_flip(cells);
    const FigureDeclaration& quality = front_quality(cells, record);
    const int samples = truth_samples(record);
    QualityCostTable table{.columns = columns_of(flip, cells),
                           .views = {},
                           .flip = flip,
                           .truth_samples = samples,
                           .mark_legend = mark_legend(quality),
                           .legend = legend_of(flip, samples)};
    const std::vector<ViewVariant> variants = view_variants(cells);
    for (std::size_t at = 0; at < cells.size(); ++at) {
        const CellResult& cell = cells[at];
        if (cell.status != CellStatus::ok) continue;
        const auto& [view, variant] = variants[at];
        view_of(table.views, view)
            .rows.push_back({.cell = &cell,
                             .setting = split_cell_id(cell.cell).first,
                             .variant = variant,
                             .figures = figures_of(cell, table.columns)});
    }
    for (QualityCostView& view : table.views) {
        sort_rows(view.rows);
        for (QualityCostRow& row : view.rows) {
            row.mark = mark_of(row, view.rows, quality);
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
