#include "gpu/shader_source.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/glsl_tokens.hpp"
#include "core/suggest.hpp"

#include <algorithm>
#include <optional>

namespace reliefbench::gpu {

std::string read_source(const ShaderSource& source, const std::string& name) {
    const auto generated = source.generated.find(name);
    if (generated != source.generated.end()) return generated->second;

    const std::filesystem::path relative(name);
    if (relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end())
        fail("'{}' leaves the folders that shaders are taken from; name a file inside them", name);

    std::optional<std::filesystem::path> found;
    for (const std::filesystem::path& root : source.roots) {
        const std::filesystem::path candidate = root / relative;
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(candidate, ignored)) continue;
        // A symbolic link may lead out of the folder although its name does not.
        const std::filesystem::path canonical_root = std::filesystem::canonical(root);
        const std::filesystem::path canonical = std::filesystem::canonical(candidate);
        const auto [root_end, rest] =
            std::mismatch(canonical_root.begin(), canonical_root.end(), canonical.begin(), canonical.end());
        if (root_end != canonical_root.end())
            fail("'{}' is a link that leads out of {}; put the file itself there", name, root.string());
        if (found) fail("'{}' exists both as {} and as {}; rename one", name, found->string(), candidate.string());
        found = candidate;
    }
    if (!found) {
        std::vector<std::string> places;
        for (const std::filesystem::path& root : source.roots)
            places.push_back(root.string());
        std::vector<std::string> names;
        for (const std::filesystem::path& file : shader_files(source))
            names.push_back(file.filename().string());
        fail("'{}' is not in {}{}", name, join(places, " or "), did_you_mean(name, names));
    }
    return std::string(without_byte_order_mark(read_text_file(*found, largest_glsl_file)));
}

std::vector<std::filesystem::path> shader_files(const ShaderSource& source) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& root : source.roots) {
        std::error_code ignored;
        for (const auto& entry : std::filesystem::directory_iterator(root, ignored)) {
            if (entry.path().extension() == ".glsl" && entry.is_regular_file(ignored)) files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace reliefbench::gpu
