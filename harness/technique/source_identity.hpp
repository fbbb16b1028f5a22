#pragma once

#include "manifest/manifest.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// What run.json says of its hashes of sources (`source_hashes`): that they are those of this file. Records without it
/// are of version 0.1.0, whose hashes are of every file of a folder but documents and pictures: equal ones tell that
/// sources are the same, different ones nothing.
inline constexpr const char* hashes_of_included_files = "included files";

/// The files of a technique's folder that its compilations include, directly or through others (of the folder
/// `shaders`, too), and its technique.json; paths below the folder, sorted. What stands in comments is not included;
/// what the preprocessor leaves out is.
std::vector<std::filesystem::path> source_files(const Manifest& manifest, const std::filesystem::path& folder,
                                                const std::filesystem::path& shaders);

/// Content hash of source_files, by name and content. What else lies in the folder (an editor's backups) changes
/// nothing.
std::string hash_technique(const Manifest& manifest, const std::filesystem::path& folder,
                           const std::filesystem::path& shaders);

/// Content hash of the shared shaders (shared_shader_folders of `folder`): of the files with names that such files have
/// (.glsl, .json, and those of stages), by their bare names, which are what includes go by. So a file that moves from
/// one of the folders to another changes nothing.
std::string hash_shared_shaders(const std::filesystem::path& folder);

}  // namespace reliefbench
