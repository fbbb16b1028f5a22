#include "report/run_format.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/csv.hpp"
#include "report/markdown.hpp"
#include "report/quality_cost_markdown.hpp"
#include "report/text_layout.hpp"
#include "store/device_share.hpp"

#include <algorithm>
#include <functional>

namespace reliefbench {

namespace {

std::string format_json(const Run& run) {
    std::string text = "[";
    for (std::size_t cell = 0; cell < run.cells.size(); ++cell) {
        text += (cell == 0 ? "\n" : ",\n") + to_json(run.cells[cell]).dump();
    }
    return text + "\n]\n";
}

/// What the times' reader must know, where there is such a thing.
std::string share_note(const Run& run, const std::function<std::string(const std::string&)>& format) {
    const std::string note = describe(device_share(run.run), "the times");
    return note.empty() ? "" : format(note);
}

}  // namespace

const std::vector<std::string>& run_format_names() {
    static const std::vector<std::string> names = {"table", "markdown", "csv", "json"};
    return names;
}

RunFormat parse_run_format(const std::string& name) {
    const std::vector<std::string>& names = run_format_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        fail("--format: there is no '{}'{}; the formats are {}", name, did_you_mean(name, names), join(names));
    }
    return static_cast<RunFormat>(found - names.begin());
}

std::string format_run(const Run& run, RunFormat format, const TableStyle& style) {
    switch (format) {
        case RunFormat::table:
            return format_table(run.cells, style, run.run) + share_note(run, [&style](const std::string& note) {
                       return indented("note: " + note, 0, style.columns);
                   });
        case RunFormat::markdown:
            return format_quality_cost_markdown(run) +
                   share_note(run, [](const std::string& note) { return markdown_text(note) + "\n\n"; });
        case RunFormat::csv:
            return format_csv(run);
        case RunFormat::json:
            return format_json(run);
    }
    return "";
}

}  // namespace reliefbench
