#include "cli/export_target.hpp"

#include "cli/output_file.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"

#include <algorithm>

namespace reliefbench {

std::vector<ExportTarget> parse_export_targets(const std::vector<std::string>& texts) {
    std::vector<ExportTarget> targets;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals + 1 == text.size()) {
            fail("--export: expected FORMAT=FILE, such as csv=cells.csv, found '{}'; the formats are {}", text,
                 join(export_format_names()));
        }
        const ExportTarget target{parse_export_format(text.substr(0, equals)), text.substr(equals + 1)};
        check_output_file(target.file, "--export");
        if (is_standard_output(target.file) && take_standard_output(targets)) {
            fail("--export {}: standard output has another export already", text);
        }
        targets.push_back(target);
    }
    return targets;
}

bool take_standard_output(const std::vector<ExportTarget>& targets) {
    return std::any_of(targets.begin(), targets.end(),
                       [](const ExportTarget& target) { return is_standard_output(target.file); });
}

void write_exports(const std::filesystem::path& folder, const std::vector<ExportTarget>& targets) {
    for (const ExportTarget& target : targets) {
        write_output(target.file, export_run(folder, target.format));
    }
}

}  // namespace reliefbench
