#include "cli/export_target.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/suggest.hpp"

namespace reliefbench {

void check_export_file(const std::filesystem::path& file, const std::string& option) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        fail("{}: there is no folder {} to write {} into; make it first", option, folder.string(),
             file.filename().string());
    }
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) {
        fail("{}: {} is no regular file; name another", option, file.string());
    }
}

std::vector<ExportTarget> parse_export_targets(const std::vector<std::string>& texts) {
    std::vector<ExportTarget> targets;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals + 1 == text.size()) {
            fail("--export: expected FORMAT=FILE, such as csv=cells.csv, found '{}'; the formats are {}", text,
                 join(export_format_names()));
        }
        const ExportTarget target{parse_export_format(text.substr(0, equals)), text.substr(equals + 1)};
        check_export_file(target.file, "--export");
        targets.push_back(target);
    }
    return targets;
}

void write_exports(const std::filesystem::path& folder, const std::vector<ExportTarget>& targets) {
    for (const ExportTarget& target : targets) {
        write_text_file(target.file, export_run(folder, target.format));
    }
}

}  // namespace reliefbench
