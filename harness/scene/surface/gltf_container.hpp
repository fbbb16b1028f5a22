#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// What of a glTF 2.0 file (.gltf, .glb) has to do with triangles, before anything is made of it.
struct GltfContainer {
    /// For messages, and for buffers beside it.
    std::filesystem::path path;
    /// The file as it is, which the binary chunk of a .glb is part of.
    std::string bytes;
    std::size_t chunk_begin = 0;
    std::size_t chunk_length = 0;
    /// The members that say where triangles are; the binary chunk has a name there, as buffers of their own have.
    std::string geometry;
};

/// Throws Error where the file is no whole glTF 2.0 file, needs an extension that is not read, or is too large.
GltfContainer open_gltf(const std::filesystem::path& path);

/// The content of a buffer by its name in `geometry`: the binary chunk, or a file in the folder. Throws Error.
std::vector<unsigned char> gltf_buffer(const GltfContainer& container, const std::string& name);

}  // namespace reliefbench
