#include "report/run_format.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/csv.hpp"
#include "report/quality_cost_markdown.hpp"

#include <algorithm>

namespace reliefbench {

namespace {

std::string format_json(const Run& run) {
    std::string text = "[";
    for (std::size_t cell = 0; cell < run.cells.size(); ++cell) {
        text += (cell == 0 ? "\n" : ",\n") + to_json(run.cells[cell]).dump();
    }
    return text + "\n]\n";
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
            return format_table(run.cells, style);
        case RunFormat::markdown:
            return format_quality_cost_markdown(run);
        case RunFormat::csv:
            return format_csv(run);
        case RunFormat::json:
            return format_json(run);
    }
    return "";
}

}  // namespace reliefbench
