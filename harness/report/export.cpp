#include "report/export.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/csv.hpp"
#include "report/github_action.hpp"
#include "report/google_benchmark.hpp"
#include "report/quality_cost_markdown.hpp"
#include "store/read_samples.hpp"
#include "store/run_folder.hpp"

#include <algorithm>

namespace reliefbench {

const std::vector<std::string>& export_format_names() {
    static const std::vector<std::string> names = {"google_benchmark", "github_action", "csv", "markdown"};
    return names;
}

ExportFormat parse_export_format(const std::string& name) {
    const std::vector<std::string>& names = export_format_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        fail("there is no export format '{}'{}; the formats are {}", name, did_you_mean(name, names), join(names));
    }
    return static_cast<ExportFormat>(found - names.begin());
}

std::string export_run(const std::filesystem::path& folder, ExportFormat format) {
    const Run run = read_run(folder);
    switch (format) {
        case ExportFormat::google_benchmark:
            return format_google_benchmark(run, read_round_medians(folder, draw_pass));
        case ExportFormat::github_action:
            return format_github_action(run);
        case ExportFormat::csv:
            return format_csv(run);
        case ExportFormat::markdown:
            return format_quality_cost_markdown(run);
    }
    return "";
}

}  // namespace reliefbench
