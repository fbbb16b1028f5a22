#include "technique/source_identity.hpp"

#include "core/file.hpp"
#include "core/glsl_includes.hpp"
#include "core/hash.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

std::string hash_files(const fs::path& folder, const std::vector<fs::path>& files) {
    std::string digest;
    for (const fs::path& file : files)
        digest += file.generic_string() + '\n' + content_hash(read_text_file(folder / file)) + '\n';
    return content_hash(digest);
}

}  // namespace

std::vector<fs::path> source_files(const Manifest& manifest, const fs::path& folder, const fs::path& shaders) {
    std::vector<fs::path> named;
    for (const std::string& stage : stage_files(manifest.shape.kind))
        named.emplace_back(stage);
    for (const PassDeclaration& pass : manifest.passes)
        named.emplace_back(pass.shader);
    std::vector<fs::path> files{"technique.json"};
    for (const IncludedGlsl& included : glsl_with_includes(named, {folder, shaders})) {
        if (included.root == 0) files.push_back(included.name);
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string hash_technique(const Manifest& manifest, const fs::path& folder, const fs::path& shaders) {
    return hash_files(folder, source_files(manifest, folder, shaders));
}

std::string hash_shared_shaders(const fs::path& folder) {
    constexpr std::array<std::string_view, 7> extensions{".comp", ".frag", ".glsl", ".json", ".tesc", ".tese", ".vert"};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path name = entry.path().filename();
        const bool is_source = std::ranges::find(extensions, name.extension().string()) != extensions.end();
        if (entry.is_regular_file() && is_source && !name.string().starts_with('.'))
            files.push_back(entry.path().lexically_relative(folder));
    }
    std::sort(files.begin(), files.end());
    return hash_files(folder, files);
}

}  // namespace reliefbench
