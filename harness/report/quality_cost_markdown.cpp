#include "report/quality_cost_markdown.hpp"

#include "core/counted.hpp"
#include "core/suggest.hpp"
#include "report/cautions.hpp"
#include "report/markdown.hpp"
#include "report/quality_cost.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <vector>

namespace reliefbench {

namespace {

std::string format_view(const QualityCostView& view, const std::vector<QualityCostColumn>& columns) {
    std::vector<std::string> titles = {"", "technique"};
    for (const QualityCostColumn& column : columns) {
        titles.push_back(column.title);
    }
    std::vector<std::vector<std::string>> rows;
    for (const QualityCostRow& row : view.rows) {
        std::vector<std::string> cells = {
            row.mark == ' ' ? "" : markdown_text(std::string(1, row.mark)),
            markdown_code(row.variant.empty() ? row.setting : row.setting + ' ' + row.variant)};
        for (const QualityCostFigure& figure : row.figures) {
            cells.push_back(figure.text);
        }
        rows.push_back(std::move(cells));
    }
    const std::string alignment = "cl" + std::string(columns.size(), 'r');
    const std::string title = view.view.empty() ? "default view" : markdown_text(view.view);
    return fmt::format("### {}\n\n{}\n", title, markdown_table(titles, alignment, rows));
}

std::string format_unmeasured(const Run& run, CellStatus status, std::string_view word) {
    std::vector<std::vector<std::string>> rows;
    for (const ReasonGroup& group : group_by_reason(run.cells, status)) {
        for (const CellResult* cell : group.cells) {
            rows.push_back({markdown_code(cell->cell), markdown_text(cell->reason)});
        }
    }
    if (rows.empty()) return "";
    return markdown_details(fmt::format("{} {}", counted(rows.size(), "cell"), word),
                            markdown_table({"cell", "why"}, "ll", rows));
}

}  // namespace

std::string format_quality_cost_markdown(const Run& run) {
    std::string text;
    const QualityCostTable table = quality_cost_table(run.cells, run.run);
    for (const QualityCostView& view : table.views) {
        text += format_view(view, table.columns);
    }
    if (!text.empty()) {
        text += fmt::format("{}. {}.\n\n", markdown_text(join(table.mark_legend, "; ")),
                            markdown_text(join(table.legend, "; ")));
        if (table.flip != RankingFlip::footprint) text += fmt::format("{}\n\n", caveat_of(table.flip));
        for (const std::string& caution : cautions(run.cells, run.run))
            text += fmt::format("**Caution:** {}\n\n", markdown_text(caution));
    }
    return text + format_unmeasured(run, CellStatus::failed, "failed") +
           format_unmeasured(run, CellStatus::skipped, "skipped");
}

}  // namespace reliefbench
