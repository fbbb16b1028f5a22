#include "technique/source_identity.hpp"

#include "core/file.hpp"
#include "core/glsl_includes.hpp"
#include "core/hash.hpp"
#include "manifest/shared_shaders.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

/// Of files by their names, sorted.
std::string hash_files(const std::map<fs::path, fs::path>& files) {
    std::string digest;
    for (const auto& [name, file] : files)
        digest += name.generic_string() + '\n' + content_hash(read_text_file(file)) + '\n';
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
    std::vector<fs::path> roots = shared_shader_folders(shaders);
    roots.insert(roots.begin(), folder);
    for (const IncludedGlsl& included : glsl_with_includes(named, roots)) {
        if (included.root == 0) files.push_back(included.name);
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string hash_technique(const Manifest& manifest, const fs::path& folder, const fs::path& shaders) {
    std::map<fs::path, fs::path> files;
    for (const fs::path& file : source_files(manifest, folder, shaders))
        files.emplace(file, folder / file);
    return hash_files(files);
}

std::string hash_shared_shaders(const fs::path& folder) {
    constexpr std::array<std::string_view, 7> extensions{".comp", ".frag", ".glsl", ".json", ".tesc", ".tese", ".vert"};
    std::map<fs::path, fs::path> files;
    for (const fs::path& part : shared_shader_folders(folder)) {
        for (const fs::directory_entry& entry : fs::directory_iterator(part)) {
            const fs::path name = entry.path().filename();
            const bool is_source = std::ranges::find(extensions, name.extension().string()) != extensions.end();
            if (entry.is_regular_file() && is_source && !name.string().starts_with('.'))
                files.emplace(name, entry.path());
        }
    }
    return hash_files(files);
}

}  // namespace reliefbench
