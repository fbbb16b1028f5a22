#include "core/error.hpp"
#include "core/file.hpp"
#include "scene/surface/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_map>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace reliefbench {

namespace {

/// What the text becomes while it is read, by its size.
constexpr std::uint64_t bytes_for_byte_of_text = 12;
/// tinyobjloader keeps their number in a byte.
constexpr std::size_t max_polygon_corners = 255;

/// How many numbers a line of this kind has at least; 0 for another line.
std::size_t numbers_of_line(std::string_view word) {
    return word == "v" || word == "vn" ? 3 : word == "vt" ? 2 : 0;
}

/// What is up to the line's end, LF, CR or both, is taken off the text.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_of("\n\r"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
    return line;
}

/// tinyobjloader takes what it cannot read for 0, a NaN too.
void check_lines(const std::filesystem::path& path, std::string_view text) {
    constexpr std::string_view blanks = " \t";
    for (std::size_t line = 1; !text.empty(); ++line) {
        std::string_view left = take_line(text);
        left = left.substr(0, left.find('#'));
        std::size_t words = 0;
        std::size_t needed = 0;
        bool is_face = false;
        for (;; ++words) {
            left.remove_prefix(std::min(left.find_first_not_of(blanks), left.size()));
            if (left.empty()) break;
            const std::string_view word = left.substr(0, left.find_first_of(blanks));
            left.remove_prefix(word.size());
            if (words == 0) {
                needed = numbers_of_line(word);
                is_face = word == "f";
                if (needed == 0 && !is_face) break;
            } else if (needed > 0 && word.find_first_not_of("0123456789+-.eE") != std::string_view::npos) {
                fail("mesh '{}', line {}: '{}' is no finite number: export it again", path.string(), line,
                     one_line(std::string(word)));
            }
        }
        if (needed > 0 && words <= needed) {
            fail("mesh '{}', line {}: {} numbers, and {} are needed: the file is damaged or cut short", path.string(),
                 line, words - 1, needed);
        }
        if (is_face && words - 1 > max_polygon_corners) {
            fail("mesh '{}', line {}: a polygon of {} corners, and no more than {} are read: triangulate it",
                 path.string(), line, words - 1, max_polygon_corners);
        }
    }
}

tinyobj::ObjReader parse_obj(const std::filesystem::path& path, const std::string& text, bool triangulate) {
    tinyobj::ObjReaderConfig settings;
    settings.triangulate = triangulate;
    settings.vertex_color = false;
    tinyobj::ObjReader reader;
    // Without materials.
    if (!reader.ParseFromString(text, "", settings))
        fail("cannot read mesh '{}': {}", path.string(), one_line(reader.Error()));
    return reader;
}

void check_index(const std::filesystem::path& path, int index, std::size_t count, const char* what) {
    if (index >= 0 && static_cast<std::size_t>(index) < count) return;
    fail("mesh '{}' is damaged: a face has the {} {}, and there are {}", path.string(), what,
         static_cast<std::int64_t>(index) + 1, count);
}

/// What all the faces, polygons as they are, refer to is there. How many triangles they make.
std::size_t check_faces(const std::filesystem::path& path, const tinyobj::ObjReader& reader) {
    const tinyobj::attrib_t& attributes = reader.GetAttrib();
    std::size_t triangles = 0;
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        for (const tinyobj::index_t& index : shape.mesh.indices) {
            check_index(path, index.vertex_index, attributes.vertices.size() / 3, "vertex");
            if (index.texcoord_index != -1)
                check_index(path, index.texcoord_index, attributes.texcoords.size() / 2, "texture coordinates");
            if (index.normal_index != -1)
                check_index(path, index.normal_index, attributes.normals.size() / 3, "normal");
        }
        // Those of less than three corners are left out already.
        for (const std::size_t corners : shape.mesh.num_face_vertices)
            triangles += std::max<std::size_t>(corners, 2) - 2;
    }
    return triangles;
}

/// Corners with the same position, texture coordinates and normal are one vertex, as in the file.
class ObjVertices {
public:
    ObjVertices(const tinyobj::attrib_t& attributes, FileMesh& mesh) : attributes_(attributes), mesh_(mesh) {}

    std::uint32_t add(const tinyobj::index_t& index) {
        const std::array<int, 3> key{index.vertex_index, index.texcoord_index, index.normal_index};
        const auto [known, is_new] = known_.emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.push_back(vertex(index));
        return known->second;
    }

private:
    struct Hash {
        std::size_t operator()(const std::array<int, 3>& key) const {
            std::size_t hash = 0;
            for (const int number : key)
                hash = hash * 1099511628211u + static_cast<unsigned>(number);
            return hash ^ (hash >> 29u);
        }
    };

    MeshVertex vertex(const tinyobj::index_t& index) const {
        const auto number = [](const std::vector<tinyobj::real_t>& numbers, int of, int per, int component) {
            return numbers[static_cast<std::size_t>(of) * static_cast<std::size_t>(per) +
                           static_cast<std::size_t>(component)];
        };
        const auto vector = [&](const std::vector<tinyobj::real_t>& numbers, int of) {
            return glm::vec3(number(numbers, of, 3, 0), number(numbers, of, 3, 1), number(numbers, of, 3, 2));
        };
        return {.position = vector(attributes_.vertices, index.vertex_index),
                .normal = index.normal_index < 0
                              ? glm::vec3(0)
                              : file_normal(glm::dvec3(vector(attributes_.normals, index.normal_index)), mesh_),
                .uv = {number(attributes_.texcoords, index.texcoord_index, 2, 0),
                       number(attributes_.texcoords, index.texcoord_index, 2, 1)}};
    }

    const tinyobj::attrib_t& attributes_;
    FileMesh& mesh_;
    std::unordered_map<std::array<int, 3>, std::uint32_t, Hash> known_;
};

}  // namespace

FileMesh read_obj_file(const std::filesystem::path& path) {
    const std::string text = read_text_file(path, max_mesh_file_bytes);
    check_mesh_size(path, bytes_for_byte_of_text * text.size(), 0);
    check_lines(path, text);
    tinyobj::ObjReader reader = parse_obj(path, text, false);
    const std::size_t triangles = check_faces(path, reader);
    check_mesh_size(path, bytes_for_byte_of_text * text.size(), triangles);
    // Whoever triangulates leaves out, without a word, what refers to nothing.
    reader = parse_obj(path, text, true);
    FileMesh mesh;
    ObjVertices vertices(reader.GetAttrib(), mesh);
    std::size_t made = 0;
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;
        made += corners.size() / 3;
        for (std::size_t corner = 0; corner + 3 <= corners.size(); corner += 3) {
            const auto has_no_uv = [](const tinyobj::index_t& index) { return index.texcoord_index < 0; };
            if (std::any_of(&corners[corner], &corners[corner] + 3, has_no_uv)) {
                ++mesh.triangles_without_uv;
                continue;
            }
            mesh.triangles.push_back(
                {vertices.add(corners[corner]), vertices.add(corners[corner + 1]), vertices.add(corners[corner + 2])});
        }
    }
    mesh.triangles_without_area = triangles - std::min(triangles, made);
    return mesh;
}

}  // namespace reliefbench
