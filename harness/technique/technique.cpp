#include "technique/technique.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/hash.hpp"
#include "core/suggest.hpp"

#include <algorithm>
#include <cstdlib>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

/// Everything but documents and pictures: whatever else lies in the folder, a shader may include.
bool shaders_can_reach(const fs::path& file) {
    const std::string extension = file.extension().string();
    return extension != ".md" && extension != ".png";
}

std::vector<fs::path> technique_folders(const fs::path& root) {
    std::error_code error;
    std::vector<fs::path> folders;
    for (fs::directory_iterator entry(root, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->is_directory() && fs::exists(entry->path() / "technique.json")) folders.push_back(entry->path());
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

std::string hash_folder(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && shaders_can_reach(entry.path())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::string digest;
    for (const fs::path& file : files)
        digest += fs::relative(file, folder).generic_string() + '\n' + content_hash(read_text_file(file)) + '\n';
    return content_hash(digest);
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

TechniqueLibrary find_techniques(const std::vector<fs::path>& roots, const fs::path& shaders) {
    TechniqueLibrary library;
    std::vector<fs::path> folders;
    for (const fs::path& root : roots) {
        for (const fs::path& folder : technique_folders(root)) {
            const auto same_id = [&](const fs::path& other) { return other.filename() == folder.filename(); };
            const auto found = std::find_if(folders.begin(), folders.end(), same_id);
            if (found != folders.end())
                fail("technique '{}' exists both as {} and as {}; rename one folder", folder.filename().string(),
                     found->string(), folder.string());
            folders.push_back(folder);
        }
    }
    const auto by_id = [](const fs::path& a, const fs::path& b) { return a.filename() < b.filename(); };
    std::sort(folders.begin(), folders.end(), by_id);
    for (const fs::path& folder : folders) {
        try {
            library.techniques.push_back({load_manifest(folder, shaders), folder, hash_folder(folder), shaders});
        } catch (const Error& error) {
            library.broken.emplace_back(folder.filename().string(), error.what());
        }
    }
    return library;
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
