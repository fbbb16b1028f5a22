#include "report/comparison_markdown.hpp"

#include "core/counted.hpp"
#include "report/comparison_words.hpp"
#include "report/markdown.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reliefbench {

namespace {

/// Rows of one table. Four tables of rows of up to about 300 characters stay below the limit of a comment.
constexpr std::size_t max_rows = 50;

using Rows = std::vector<std::vector<std::string>>;

/// A table of at most `max_rows`, and how many more there are.
std::string cut_table(const std::vector<std::string>& titles, std::string_view alignment, Rows rows) {
    const std::size_t left_out = rows.size() - std::min(rows.size(), max_rows);
    rows.resize(rows.size() - left_out);
    std::string table = markdown_table(titles, alignment, rows);
    if (left_out > 0) table += fmt::format("\nand {} more\n", left_out);
    return table;
}

/// Its id, and what else there is to say of it.
std::string cell_text(const CellComparison& cell, const Comparison& comparison) {
    const std::string reason = reason_beyond_figures(cell, comparison);
    return markdown_code(cell.cell) + (reason.empty() ? "" : "<br>" + markdown_text(reason));
}

std::string format_changed(const Comparison& comparison) {
    Rows rows;
    for (const Verdict verdict : {Verdict::slower, Verdict::faster}) {
        for (const CellComparison* cell : cells_with(comparison, verdict)) {
            rows.push_back({verdict == Verdict::slower ? "**slower**" : "faster", cell_text(*cell, comparison),
                            change_text(cell->time.ratio), change_interval_text(cell->time.ci95),
                            percent_text(cell->time.visible)});
        }
    }
    if (rows.empty()) return "";
    return cut_table({"time", "cell", "change", "95 %", "visible"}, "llrrr", rows) + '\n';
}

void add_changes(Rows& rows, const std::string& title, const std::vector<const CellComparison*>& cells) {
    constexpr std::size_t fields_named = 3;
    for (const CellComparison* cell : cells) {
        std::string changes;
        for (const std::string& change : quality_change_texts(cell->quality, fields_named)) {
            changes += (changes.empty() ? "" : "<br>") + markdown_text(change);
        }
        rows.push_back({title, markdown_code(cell->cell), changes});
    }
}

std::string format_quality(const Comparison& comparison) {
    Rows rows;
    add_changes(rows, "**worse**", cells_with(comparison, QualityVerdict::worse));
    add_changes(rows, "**mixed**", cells_with(comparison, QualityVerdict::mixed));
    add_changes(rows, "better", cells_with(comparison, QualityVerdict::better));
    return rows.empty() ? "" : cut_table({"quality", "cell", "base → new"}, "lll", rows) + '\n';
}

std::string format_other_changes(const Comparison& comparison) {
    Rows rows;
    add_changes(rows, "not comparable", cells_with_other_changes(comparison, QualityVerdict::not_comparable));
    add_changes(rows, "same", cells_with_other_changes(comparison, QualityVerdict::same));
    if (rows.empty()) return "";
    return markdown_details(fmt::format("{} with other changes", counted(rows.size(), "cell")),
                            cut_table({"quality", "cell", "base → new"}, "lll", rows));
}

Rows uncompared_rows(const Comparison& comparison, bool failed_now) {
    Rows rows;
    for (const UncomparedGroup& group : uncompared_by_reason(comparison)) {
        if (group.failed_now != failed_now) continue;
        for (const std::string& cell : group.cells) {
            rows.push_back({markdown_code(cell), markdown_text(group.reason)});
        }
    }
    return rows;
}

std::string format_undecided(const Comparison& comparison) {
    Rows rows;
    for (const CellComparison* cell : cells_with(comparison, Verdict::undecided)) {
        rows.push_back({cell_text(*cell, comparison), change_text(cell->time.ratio),
                        change_interval_text(cell->time.ci95), percent_text(cell->time.visible),
                        more_text(cell->time)});
    }
    if (rows.empty()) return "";
    const std::string summary = fmt::format("{} undecided", counted(rows.size(), "cell"));
    return markdown_details(summary,
                            cut_table({"cell", "change", "95 %", "visible", "more " + comparison.unit}, "lrrrr", rows));
}

std::string format_environment(const Comparison& comparison) {
    constexpr int indent = 2;
    const std::string json = comparison.environment.dump(indent, ' ', false, Json::error_handler_t::replace);
    return markdown_details("what was measured on", fmt::format("```json\n{}\n```\n", json));
}

}  // namespace

std::string format_comparison_markdown(const Comparison& comparison) {
    std::string text = fmt::format("**reliefbench: {}**\n\n", markdown_text(summary_line(comparison)));
    for (const std::string& notice : comparison.notices) {
        text += fmt::format("- {}\n", markdown_text(notice));
    }
    if (!comparison.notices.empty()) text += '\n';
    text += format_changed(comparison) + format_quality(comparison);
    if (const Rows failed = uncompared_rows(comparison, true); !failed.empty()) {
        text += cut_table({"failed now", "why"}, "ll", failed) + '\n';
    }
    if (!comparison.cells.empty() && !comparison.quality_only) {
        text += fmt::format(
            "Threshold {}. Change: of the time, new against base, with its 95 % interval. Visible: the "
            "smallest change that this evidence would have shown.\n\n",
            percent_text(comparison.threshold));
    }
    if (!comparison.cells.empty()) {
        text += fmt::format("Quality is decided by changes beyond these: {}.\n\n",
                            markdown_text(deciding_figures_text(comparison.deciding_figures)));
    }
    text += format_undecided(comparison) + format_other_changes(comparison);
    if (const Rows rows = uncompared_rows(comparison, false); !rows.empty()) {
        text += markdown_details(fmt::format("{} not compared", counted(rows.size(), "cell")),
                                 cut_table({"cell", "why"}, "ll", rows));
    }
    return text + format_environment(comparison);
}

}  // namespace reliefbench
