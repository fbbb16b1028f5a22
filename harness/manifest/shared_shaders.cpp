#include "manifest/shared_shaders.hpp"

namespace reliefbench {

std::vector<std::filesystem::path> shared_shader_folders(const std::filesystem::path& shared) {
    if (shared.empty()) return {};
    std::error_code ignored;
    std::vector<std::filesystem::path> folders;
    for (const char* part : {"contract", "driver", "library"}) {
        if (std::filesystem::is_directory(shared / part, ignored)) folders.push_back(shared / part);
    }
    if (folders.empty()) folders.push_back(shared);
    return folders;
}

std::filesystem::path find_shared_file(const std::filesystem::path& shared, const std::string& name) {
    for (const std::filesystem::path& folder : shared_shader_folders(shared)) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(folder / name, ignored)) return folder / name;
    }
    return {};
}

}  // namespace reliefbench
