#include "sweep/input_path.hpp"

#include "core/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace reliefbench {

std::string resolve_input_path(const JsonView& view, const std::vector<std::filesystem::path>& folders,
                               const std::string& neither, const std::string& known) {
    const std::string name = view.string();
    bool is_folder = false;
    for (const std::filesystem::path& folder : folders) {
        const std::filesystem::path candidate = std::filesystem::absolute(folder / name).lexically_normal();
        std::error_code ignored;
        if (std::filesystem::is_regular_file(candidate, ignored)) return candidate.string();
        is_folder = is_folder || std::filesystem::is_directory(candidate, ignored);
    }
    if (is_folder) view.fail_here(fmt::format("'{}' is a folder; name a file in it", name));
    // Wherever it is looked for.
    if (std::filesystem::path(name).is_absolute()) view.fail_here(fmt::format("there is no file '{}'", name));
    std::vector<std::string> tried;
    for (const std::filesystem::path& folder : folders) {
        const std::string absolute = std::filesystem::weakly_canonical(folder).string();
        if (std::ranges::find(tried, absolute) == tried.end()) tried.push_back(absolute);
    }
    if (neither.empty()) view.fail_here(fmt::format("no file '{}' in {}", name, join(tried, " or ")));
    view.fail_here(fmt::format("'{}' is {} nor a file in {}; {}", name, neither, join(tried, " or "), known));
}

}  // namespace reliefbench
