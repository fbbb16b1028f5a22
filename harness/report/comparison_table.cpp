#include "report/comparison_table.hpp"

#include "core/counted.hpp"
#include "report/comparison_words.hpp"
#include "report/figure_rows.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// Named without --all: changed fields of a cell, and cells under each reason for not being compared.
constexpr std::size_t table_fields_named = 5;
constexpr std::size_t group_cells_named = 3;

std::string format_verdict(const Comparison& comparison, Verdict verdict, std::size_t columns) {
    const std::vector<const CellComparison*> cells = cells_with(comparison, verdict);
    if (cells.empty()) return "";
    std::vector<FigureColumn> titles = {{"change"}, {"95 %"}, {"visible"}, {"quality"}};
    if (verdict == Verdict::undecided) titles.push_back({"more " + comparison.unit});
    std::vector<std::vector<std::string>> figures;
    std::vector<std::string> ids;
    for (const CellComparison* cell : cells) {
        figures.push_back({change_text(cell->time.ratio), change_interval_text(cell->time.ci95),
                           percent_text(cell->time.visible), std::string(to_string(cell->quality.verdict))});
        if (verdict == Verdict::undecided) figures.back().push_back(more_text(cell->time));
        const std::string reason = reason_beyond_figures(*cell, comparison);
        ids.push_back(reason.empty() ? cell->cell : cell->cell + "\n(" + reason + ")");
    }
    return fmt::format("{}, {}\n{}\n", to_string(verdict), counted(cells.size(), "cell"),
                       format_figure_rows(titles, figures, ids, columns));
}

std::string format_changes(std::string_view title, const std::vector<const CellComparison*>& cells,
                           const ComparisonTableOptions& options) {
    if (cells.empty()) return "";
    std::string text = indented(fmt::format("{}, {}", title, counted(cells.size(), "cell")), 0, options.columns);
    for (const CellComparison* cell : cells) {
        text += indented(cell->cell, space_between, options.columns);
        const std::optional<std::size_t> limit = options.all ? std::nullopt : std::optional(table_fields_named);
        for (const std::string& change : quality_change_texts(cell->quality, limit)) {
            text += indented(change, 3 * space_between, options.columns);
        }
    }
    return text + '\n';
}

std::string format_quality(const Comparison& comparison, const ComparisonTableOptions& options) {
    std::string text = format_changes("worse quality", cells_with(comparison, QualityVerdict::worse), options);
    const std::string_view advice = comparison.accept_mixed ? "" : "; --accept-mixed lets it pass";
    text += format_changes(fmt::format("mixed quality (some figures better, others worse{})", advice),
                           cells_with(comparison, QualityVerdict::mixed), options);
    text += format_changes("better quality", cells_with(comparison, QualityVerdict::better), options);
    for (const auto& [title, verdict] : {std::pair("quality not comparable", QualityVerdict::not_comparable),
                                         std::pair("same quality", QualityVerdict::same)}) {
        const auto large = cells_with_other_changes(comparison, verdict);
        const auto all = cells_with_other_changes(comparison, verdict, true);
        text += format_changes(fmt::format("{}, other changes", title), options.all ? all : large, options);
        if (options.all || all.size() == large.size()) continue;
        text += indented(fmt::format("{}, changes within the tolerances, {} (--all lists them)", title,
                                     counted(all.size() - large.size(), "cell")),
                         0, options.columns) +
                '\n';
    }
    return text;
}

std::string format_uncompared(const Comparison& comparison, const ComparisonTableOptions& options) {
    std::string text;
    for (const UncomparedGroup& group : uncompared_by_reason(comparison)) {
        text += indented(fmt::format("{}, {}: {}", group.failed_now ? "failed now" : "not compared",
                                     counted(group.cells.size(), "cell"), group.reason),
                         0, options.columns);
        const std::size_t named = options.all ? group.cells.size() : std::min(group_cells_named, group.cells.size());
        for (std::size_t cell = 0; cell < named; ++cell) {
            text += indented(group.cells[cell], 2 * space_between, options.columns);
        }
        if (named < group.cells.size()) {
            text +=
                indented(fmt::format("and {} more", group.cells.size() - named), 2 * space_between, options.columns);
        }
    }
    return text.empty() ? text : text + '\n';
}

}  // namespace

std::string format_comparison_table(const Comparison& comparison, const ComparisonTableOptions& options) {
    std::string text;
    for (const std::string& notice : comparison.notices) {
        text += indented("note: " + notice, 0, options.columns);
    }
    if (!text.empty()) text += '\n';
    for (const Verdict verdict : {Verdict::slower, Verdict::undecided, Verdict::faster}) {
        text += format_verdict(comparison, verdict, options.columns);
    }
    if (options.all) text += format_verdict(comparison, Verdict::same, options.columns);
    text += format_quality(comparison, options);
    text += format_uncompared(comparison, options);
    if (!comparison.cells.empty() && !comparison.quality_only) {
        text += indented(fmt::format("threshold {}; change: of the time, new against base; 95 %: its interval; "
                                     "visible: the smallest change that this evidence would have shown",
                                     percent_text(comparison.threshold)),
                         0, options.columns);
    }
    if (!comparison.cells.empty()) {
        text += indented(
            "quality is decided by changes beyond these: " + deciding_figures_text(comparison.deciding_figures), 0,
            options.columns);
    }
    return text + indented(summary_line(comparison), 0, options.columns);
}

}  // namespace reliefbench
