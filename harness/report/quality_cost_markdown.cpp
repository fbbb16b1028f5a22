#include "report/quality_cost_markdown.hpp"

#include "report/markdown.hpp"
#include "report/quality_cost.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <vector>

namespace reliefbench {

namespace {

std::string format_view(const QualityCostView& view) {
    std::vector<std::string> titles = {"", "technique"};
    titles.insert(titles.end(), quality_cost_titles().begin(), quality_cost_titles().end());
    std::vector<std::vector<std::string>> rows;
    for (const QualityCostRow& row : view.rows) {
        std::vector<std::string> cells = {row.mark == ' ' ? "" : markdown_text(std::string(1, row.mark)),
                                          markdown_code(split_cell_id(row.cell->cell).first)};
        cells.insert(cells.end(), row.columns.begin(), row.columns.end());
        rows.push_back(std::move(cells));
    }
    const std::string alignment = "cl" + std::string(quality_cost_titles().size(), 'r');
    const std::string title = view.view.empty() ? "default view" : markdown_text(view.view);
    return fmt::format("### {}\n\n{}\n", title, markdown_table(titles, alignment, rows));
}

std::string format_unmeasured(const Run& run, CellStatus status, std::string_view word) {
    std::vector<std::vector<std::string>> rows;
    for (const ReasonGroup& group : group_by_reason(run.cells, status)) {
        for (const std::string& cell : group.cells) {
            rows.push_back({markdown_code(cell), markdown_text(group.reason)});
        }
    }
    if (rows.empty()) return "";
    return markdown_details(fmt::format("{} {}", counted(rows.size(), "cell"), word),
                            markdown_table({"cell", "why"}, "ll", rows));
}

}  // namespace

std::string format_quality_cost_markdown(const Run& run) {
    std::string text;
    for (const QualityCostView& view : quality_cost_views(run.cells)) {
        text += format_view(view);
    }
    if (!text.empty()) {
        text +=
            "\\* nothing in the view is both faster and better (UV p99); ! missed + false hits above 0.5 %: its errors "
            "do not count. ms: median ± MAD of the draw; prep: making its maps; uv: texels; depth: patch sides; "
            "missed, false: % of the footprint.\n\n";
    }
    return text + format_unmeasured(run, CellStatus::failed, "failed") +
           format_unmeasured(run, CellStatus::skipped, "skipped");
}

}  // namespace reliefbench
