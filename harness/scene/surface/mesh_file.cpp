#include "scene/surface/mesh_file.hpp"

#include "core/error.hpp"
#include "core/memory.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <system_error>

namespace reliefbench {

namespace {

/// By which a vector of single precision may miss unit length.
constexpr double unit_rounding = 1e-6;
/// Of a triangle with its vertices, in the reader and where charts are found.
constexpr std::uint64_t bytes_of_triangle = 400;

std::string mesh_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

void check_is_mesh_file(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) fail("there is no mesh file '{}'", path.string());
    if (!std::filesystem::is_regular_file(status)) fail("'{}' is no file: give {}", path.string(), readable_meshes());
    if (!is_mesh_file_name(path)) {
        fail("cannot read mesh '{}': its name ends in '{}'; give {}", path.string(), path.extension().string(),
             readable_meshes());
    }
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error) fail("cannot read mesh '{}': {}", path.string(), error.message());
    if (bytes == 0) fail("mesh '{}' is empty: give {}", path.string(), readable_meshes());
    if (bytes > max_mesh_file_bytes) {
        fail("mesh '{}' is of {}, and no more than {} are read: simplify it", path.string(), memory_text(bytes),
             memory_text(max_mesh_file_bytes));
    }
}

}  // namespace

bool is_mesh_file_name(const std::filesystem::path& path) {
    const std::string extension = mesh_extension(path);
    return extension == ".obj" || extension == ".gltf" || extension == ".glb";
}

std::string readable_meshes() {
    return "an OBJ or glTF 2.0 file (.obj, .gltf, .glb)";
}

FileMesh read_mesh_file(const std::filesystem::path& path) {
    check_is_mesh_file(path);
    return mesh_extension(path) == ".obj" ? read_obj_file(path) : read_gltf_file(path);
}

void check_mesh_size(const std::filesystem::path& path, std::uint64_t bytes, std::size_t triangles) {
    if (triangles > max_file_triangles) {
        fail("mesh '{}' has {} triangles, and no more than {} are read: simplify it", path.string(), triangles,
             max_file_triangles);
    }
    const std::uint64_t needed = bytes + triangles * bytes_of_triangle;
    const std::uint64_t available = available_memory();
    if (needed <= available) return;
    fail("mesh '{}' takes {} to read, and {} is available: simplify it", path.string(), memory_text(needed),
         memory_text(available));
}

std::string one_line(std::string message) {
    while (!message.empty() && (message.back() == '\n' || message.back() == ' '))
        message.pop_back();
    std::ranges::replace(message, '\n', ' ');
    // Libraries quote what they read, whole buffers written out as text too.
    constexpr std::size_t longest = 300;
    if (message.size() > longest) {
        message.resize(longest);
        message += "...";
    }
    std::ranges::replace_if(
        message, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    return message.empty() ? "no reason given" : message;
}

glm::vec3 file_normal(const glm::dvec3& direction, FileMesh& mesh) {
    const double length = glm::length(direction);
    if (!std::isfinite(length) || length == 0) {
        ++mesh.bad_normals;
        return glm::vec3(0);
    }
    return std::abs(length - 1) <= unit_rounding ? glm::vec3(direction) : glm::vec3(direction / length);
}

}  // namespace reliefbench
