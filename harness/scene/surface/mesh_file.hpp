#pragma once

#include "scene/surface/base_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// What a file holds of triangles, before it is a base: all its objects at their places, in the file's units.
struct FileMesh {
    /// (u, v) as everywhere here, v = 0 at the bottom row of a picture. A normal is of unit length; (0, 0, 0): the file
    /// has none.
    std::vector<MeshVertex> vertices;
    /// Counterclockwise from their front.
    std::vector<BaseMesh::Triangle> triangles;
    /// Left out, as they have no texture coordinates.
    std::size_t triangles_without_uv = 0;
    /// Left out, of polygons of which no triangle could be made.
    std::size_t triangles_without_area = 0;
    /// Vertices whose normal the file gives as zero or not finite: they have none then.
    std::size_t bad_normals = 0;
};

/// A file of more is not read.
inline constexpr std::size_t max_file_triangles = 10'000'000;
inline constexpr std::uint64_t max_mesh_file_bytes = std::uint64_t{1} << 30;

/// Whether the name ends in .obj, .gltf or .glb, in whatever case.
bool is_mesh_file_name(const std::filesystem::path& path);

/// For messages: "an OBJ or glTF 2.0 file (.obj, .gltf, .glb)".
std::string readable_meshes();

/// Throws Error for a file that is missing, damaged, larger than the limits above or than memory, of another format, or
/// that needs what is not read; indices, buffers and numbers are checked.
FileMesh read_mesh_file(const std::filesystem::path& path);

/// Each in the only file that knows tinygltf, or tinyobjloader: headers whose code is compiled there, so that the
/// program needs no library of theirs at run time, in the portable build as in any.
FileMesh read_gltf_file(const std::filesystem::path& path);
FileMesh read_obj_file(const std::filesystem::path& path);

/// Throws Error where there is not the memory for so many bytes, or more triangles than are read.
void check_mesh_size(const std::filesystem::path& path, std::uint64_t bytes, std::size_t triangles);

/// A library's complaints on one line.
std::string one_line(std::string message);

/// The unit vector of this direction; (0, 0, 0), counted, where it has none. One of unit length stays as it is.
glm::vec3 file_normal(const glm::dvec3& direction, FileMesh& mesh);

}  // namespace reliefbench
