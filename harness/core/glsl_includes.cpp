#include "core/glsl_includes.hpp"

#include "core/file.hpp"

#include <algorithm>
#include <set>

namespace reliefbench {

namespace {

bool leaves_its_folder(const std::filesystem::path& name) {
    return name.is_absolute() || std::ranges::find(name, "..") != name.end();
}

}  // namespace

std::vector<IncludedGlsl> glsl_with_includes(const std::vector<std::filesystem::path>& files,
                                             const std::vector<std::filesystem::path>& roots) {
    std::vector<IncludedGlsl> all;
    std::set<std::filesystem::path> seen;
    std::vector<std::filesystem::path> left(files.rbegin(), files.rend());
    while (!left.empty()) {
        const std::filesystem::path name = left.back().lexically_normal();
        left.pop_back();
        if (leaves_its_folder(name) || !seen.insert(name).second) continue;
        for (std::size_t root = 0; root < roots.size(); ++root) {
            std::error_code ignored;
            if (roots[root].empty() || !std::filesystem::is_regular_file(roots[root] / name, ignored)) continue;
            all.push_back({root, name, glsl_tokens(read_text_file(roots[root] / name, largest_glsl_file))});
            for (const GlslToken& token : all.back().tokens) {
                if (std::string included = included_file(token); !included.empty()) left.emplace_back(included);
            }
        }
    }
    return all;
}

}  // namespace reliefbench
