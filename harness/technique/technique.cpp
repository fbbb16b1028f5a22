#include "technique/technique.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "gpu/device.hpp"
#include "technique/source_identity.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_file = "technique.json";

/// Where a path leads, whatever links it goes through; one that leads nowhere as it is.
fs::path real_path(const fs::path& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    return error ? path : real;
}

std::vector<fs::path> technique_folders(const fs::path& root) {
    std::error_code error;
    std::vector<fs::path> folders;
    for (fs::directory_iterator entry(root, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->is_directory() && fs::exists(entry->path() / manifest_file)) folders.push_back(entry->path());
    }
    if (error) fail("cannot look for techniques in {}: {}", root.string(), error.message());
    return folders;
}

fs::path shaders_in(const fs::path& folder) {
    return folder / "harness" / "shaders";
}

fs::path data_folder() {
    if (const char* folder = std::getenv("RELIEFBENCH_DATA_DIR")) return folder;
    std::error_code ignored;
    const fs::path binary_folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    const fs::path above = binary_folder.parent_path();
    for (const fs::path& folder : {binary_folder, above, above / "share" / "reliefbench"}) {
        if (!folder.empty() && fs::is_directory(shaders_in(folder), ignored)) return folder;
    }
    return RELIEFBENCH_SOURCE_DIR;
}

}  // namespace

std::string complaint_of_root(const fs::path& root) {
    std::error_code ignored;
    if (!fs::is_directory(root, ignored) || !technique_folders(root).empty()) return {};
    if (fs::exists(root / manifest_file, ignored)) {
        const fs::path above = (fs::absolute(root) / ".").lexically_normal().parent_path().parent_path();
        return fmt::format("{} is one technique's folder; name the folder that holds it: {}", root.string(),
                           above.string());
    }
    const bool is_checkout = fs::is_directory(root / "techniques", ignored);
    return fmt::format("{} holds no technique folder, which is one with a {}{}", root.string(), manifest_file,
                       is_checkout ? "; do you mean " + (root / "techniques").string() + "?" : "");
}

std::vector<Manifest> TechniqueLibrary::manifests() const {
    std::vector<Manifest> result;
    for (const Technique& technique : techniques)
        result.push_back(technique.manifest);
    return result;
}

const Technique& TechniqueLibrary::get(const std::string& id) const {
    std::vector<std::string> known;
    for (const Technique& technique : techniques) {
        if (technique.manifest.id == id) return technique;
        known.push_back(technique.manifest.id);
    }
    for (const auto& [broken_id, reason] : broken) {
        if (broken_id == id) fail("technique '{}' cannot be used: {}", id, reason);
    }
    fail("there is no technique '{}'{}; there are: {}", id, did_you_mean(id, known), join(known));
}

TechniqueLibrary find_techniques(const std::vector<fs::path>& roots, const fs::path& shaders, SameId same_id) {
    TechniqueLibrary library;
    std::vector<fs::path> folders;
    for (const fs::path& root : roots) {
        for (const fs::path& folder : technique_folders(root)) {
            const auto has_id = [&](const fs::path& other) { return other.filename() == folder.filename(); };
            const auto found = std::find_if(folders.begin(), folders.end(), has_id);
            if (found == folders.end()) {
                folders.push_back(folder);
            } else if (same_id == SameId::last_wins || found->parent_path() == roots.front()) {
                *found = folder;
            } else if (real_path(*found) != real_path(folder)) {
                fail("technique '{}' exists both as {} and as {}; rename one folder", folder.filename().string(),
                     found->string(), folder.string());
            }
        }
    }
    const auto by_id = [](const fs::path& a, const fs::path& b) { return a.filename() < b.filename(); };
    std::sort(folders.begin(), folders.end(), by_id);
    for (const fs::path& folder : folders) {
        try {
            Manifest manifest = load_manifest(folder, shaders, gpu::feature_names());
            std::string hash = hash_technique(manifest, folder, shaders);
            library.techniques.push_back({std::move(manifest), folder, std::move(hash), shaders});
        } catch (const std::exception& error) {
            // Error, or what a file system says of a folder that it cannot read.
            library.broken.emplace_back(folder.filename().string(), error.what());
        }
    }
    return library;
}

bool takes_place_of_shipped(const Technique& technique) {
    const fs::path shipped = default_technique_root() / technique.manifest.id;
    std::error_code ignored;
    return fs::exists(shipped / manifest_file, ignored) && !fs::equivalent(technique.folder, shipped, ignored);
}

fs::path default_technique_root() {
    return data_folder() / "techniques";
}

fs::path shader_root() {
    return shaders_in(data_folder());
}

fs::path configuration_root() {
    return data_folder() / "configs";
}

}  // namespace reliefbench
