#include "report/comparison_format.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/comparison_json.hpp"
#include "report/comparison_markdown.hpp"
#include "report/workflow_commands.hpp"

#include <algorithm>

namespace reliefbench {

const std::vector<std::string>& comparison_format_names() {
    static const std::vector<std::string> names = {"table", "markdown", "json", "github"};
    return names;
}

ComparisonFormat parse_comparison_format(const std::string& name) {
    const std::vector<std::string>& names = comparison_format_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        fail("there is no format '{}'{}; the formats are {}", name, did_you_mean(name, names), join(names));
    }
    return static_cast<ComparisonFormat>(found - names.begin());
}

std::string format_comparison(const Comparison& comparison, ComparisonFormat format,
                              const ComparisonTableOptions& table) {
    switch (format) {
        case ComparisonFormat::table:
            return format_comparison_table(comparison, table);
        case ComparisonFormat::markdown:
            return format_comparison_markdown(comparison);
        case ComparisonFormat::json:
            return format_comparison_json(comparison);
        case ComparisonFormat::github:
            return format_workflow_commands(comparison);
    }
    return "";
}

}  // namespace reliefbench
