#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// The folders of shared GLSL below `shared` (harness/shaders): contract/, what a technique sees; driver/, the stages
/// around it; library/, pieces for techniques. Files include each other by their bare names, of which no two of the
/// folders have the same. Where there is no contract/, as in checkouts of version 0.1.0, `shared` holds the files
/// itself and is the only one. Empty where `shared` is.
std::vector<std::filesystem::path> shared_shader_folders(const std::filesystem::path& shared);

/// Where the shared file of that bare name lies; the empty path where there is none.
std::filesystem::path find_shared_file(const std::filesystem::path& shared, const std::string& name);

}  // namespace reliefbench
