#include "report/history_format.hpp"

#include "compare/describe.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/figure_rows.hpp"
#include "report/markdown.hpp"
#include "report/sparkline.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace reliefbench {

namespace {

/// Runs that a sparkline shows: the newest.
constexpr std::size_t max_runs_drawn = 60;
/// Cells named in a group that moved together.
constexpr std::size_t moved_cells_named = 5;

/// The run as it is counted for people, from 1.
std::size_t number_of(std::size_t run) {
    return run + 1;
}

std::string changes_text(const CellHistory& cell) {
    std::vector<std::string> texts;
    for (const ChangePoint& change : cell.changes) {
        texts.push_back(fmt::format("{} at {}", signed_percent(change.ratio - 1), number_of(change.run)));
    }
    return join(texts);
}

std::string series_text(const CellHistory& cell) {
    const std::size_t left_out = cell.median_ms.size() - std::min(cell.median_ms.size(), max_runs_drawn);
    std::vector<std::size_t> marks;
    for (const ChangePoint& change : cell.changes) {
        if (change.run >= left_out) marks.push_back(change.run - left_out);
    }
    const std::span<const std::optional<double>> values(cell.median_ms);
    return (left_out > 0 ? "…" : "") + sparkline(values.subspan(left_out), marks);
}

/// The newest value that there is.
std::string newest_ms(const CellHistory& cell) {
    for (auto value = cell.median_ms.rbegin(); value != cell.median_ms.rend(); ++value) {
        if (*value && std::isfinite(**value)) return significant(**value, 4);
    }
    return undefined;
}

std::vector<std::string> cells_of(const History& history, const MovedTogether& group) {
    std::vector<std::string> cells;
    for (std::size_t index = 0; index < std::min(moved_cells_named, group.cells.size()); ++index) {
        cells.push_back(history.cells[group.cells[index]].cell);
    }
    if (group.cells.size() > moved_cells_named)
        cells.push_back(fmt::format("and {} more", group.cells.size() - moved_cells_named));
    return cells;
}

std::string run_text(const History& history, std::size_t run) {
    return fmt::format("run {} ({})", number_of(run), history.runs[run]);
}

std::string summary_text(const History& history) {
    const auto changed = std::count_if(history.cells.begin(), history.cells.end(),
                                       [](const CellHistory& cell) { return !cell.changes.empty(); });
    return fmt::format("{} over {}: {} changed", counted(history.cells.size(), "cell"),
                       counted(history.runs.size(), "run"), changed);
}

std::string format_table(const History& history, std::size_t columns) {
    std::vector<std::vector<std::string>> figures;
    std::vector<std::string> ids;
    for (const CellHistory& cell : history.cells) {
        figures.push_back({newest_ms(cell), series_text(cell), changes_text(cell)});
        ids.push_back(cell.cell);
    }
    std::string text;
    if (!figures.empty()) {
        text += format_figure_rows({{"newest ms"}, {"series", Alignment::left}, {"changes", Alignment::left}}, figures,
                                   ids, columns) +
                '\n';
    }
    for (const MovedTogether& group : history.groups) {
        text += indented(group.text, 0, columns);
        for (const std::string& cell : cells_of(history, group)) {
            text += indented(cell, 4, columns);
        }
    }
    for (const RecordChange& change : history.record_changes) {
        text += indented(fmt::format("{}, against the one before it: {}", run_text(history, change.run),
                                     join(change.differences, "; ")),
                         0, columns);
    }
    if (!history.groups.empty() || !history.record_changes.empty()) text += '\n';
    return text + indented(summary_text(history), 0, columns);
}

std::string format_markdown(const History& history) {
    std::string text = fmt::format("**reliefbench: {}**\n\n", markdown_text(summary_text(history)));
    for (const MovedTogether& group : history.groups) {
        text += fmt::format("- {}\n", markdown_text(group.text));
    }
    for (const RecordChange& change : history.record_changes) {
        text += fmt::format("- {}, against the one before it: {}\n", markdown_text(run_text(history, change.run)),
                            markdown_text(join(change.differences, "; ")));
    }
    if (!history.groups.empty() || !history.record_changes.empty()) text += '\n';
    std::vector<std::vector<std::string>> rows;
    for (const CellHistory& cell : history.cells) {
        rows.push_back({markdown_code(cell.cell), newest_ms(cell), series_text(cell), changes_text(cell)});
    }
    return text + markdown_table({"cell", "newest ms", "series", "changes"}, "lrll", rows);
}

Json cell_to_json(const CellHistory& cell) {
    Json json;
    json["cell"] = cell.cell;
    json["median_ms"] = Json::array();
    for (const std::optional<double>& value : cell.median_ms) {
        json["median_ms"].push_back(value ? finite_or_null(*value) : Json(nullptr));
    }
    json["changes"] = Json::array();
    for (const ChangePoint& change : cell.changes) {
        json["changes"].push_back({{"run", change.run},
                                   {"previous", change.previous},
                                   {"ratio", finite_or_null(change.ratio)},
                                   {"p", finite_or_null(change.p)}});
    }
    return json;
}

/// Runs are counted from 0, as indices into "runs".
std::string format_json(const History& history) {
    Json json;
    json["runs"] = history.runs;
    json["cells"] = Json::array();
    for (const CellHistory& cell : history.cells) {
        json["cells"].push_back(cell_to_json(cell));
    }
    json["groups"] = Json::array();
    for (const MovedTogether& group : history.groups) {
        Json cells = Json::array();
        for (const std::size_t cell : group.cells) {
            cells.push_back(history.cells[cell].cell);
        }
        json["groups"].push_back({{"run", group.run},
                                  {"slower", group.slower},
                                  {"cells", std::move(cells)},
                                  {"smallest_ratio", finite_or_null(group.smallest_ratio)},
                                  {"largest_ratio", finite_or_null(group.largest_ratio)},
                                  {"text", group.text}});
    }
    json["record_changes"] = Json::array();
    for (const RecordChange& change : history.record_changes) {
        json["record_changes"].push_back({{"run", change.run}, {"differences", change.differences}});
    }
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

const std::vector<std::string>& history_format_names() {
    static const std::vector<std::string> names = {"table", "markdown", "json"};
    return names;
}

HistoryFormat parse_history_format(const std::string& name) {
    const std::vector<std::string>& names = history_format_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        fail("there is no format '{}'{}; the formats are {}", name, did_you_mean(name, names), join(names));
    }
    return static_cast<HistoryFormat>(found - names.begin());
}

std::string format_history(const History& history, HistoryFormat format, std::size_t columns) {
    switch (format) {
        case HistoryFormat::table:
            return format_table(history, columns);
        case HistoryFormat::markdown:
            return format_markdown(history);
        case HistoryFormat::json:
            return format_json(history);
    }
    return "";
}

}  // namespace reliefbench
