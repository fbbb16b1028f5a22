#include "core/error.hpp"
#include "core/json.hpp"
#include "scene/surface/gltf_container.hpp"
#include "scene/surface/mesh_file.hpp"

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

// Pictures are not looked at.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

namespace reliefbench {

namespace {

/// Where tinygltf gets its buffers from: `user` is the container.
bool give_buffer(std::vector<unsigned char>* bytes, std::string* error, const std::string& name, void* user) {
    try {
        *bytes = gltf_buffer(*static_cast<const GltfContainer*>(user), name);
    } catch (const Error& problem) {
        *error = problem.what();
        return false;
    }
    return true;
}

/// tinygltf gets to see the part that has to do with triangles alone: its readers trust what they read.
tinygltf::Model load_model(const std::filesystem::path& path) {
    GltfContainer container = open_gltf(path);
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({.FileExists = [](const std::string&, void*) { return true; },
                           .ExpandFilePath = [](const std::string& name, void*) { return name; },
                           .ReadWholeFile = give_buffer,
                           .WriteWholeFile = nullptr,
                           .user_data = &container});
    tinygltf::Model model;
    std::string errors;
    std::string warnings;
    bool loaded = false;
    try {
        loaded = loader.LoadASCIIFromString(&model, &errors, &warnings, container.geometry.data(),
                                            static_cast<unsigned>(container.geometry.size()), "");
    } catch (const std::logic_error& problem) {
        errors += problem.what();
    } catch (const nlohmann::json::exception& problem) {
        errors += problem.what();
    }
    if (!loaded) fail("cannot read mesh '{}': {}", path.string(), one_line(errors));
    if (!model.asset.version.starts_with("2.")) {
        fail("mesh '{}' is of version {} of glTF: export it as glTF 2.0", path.string(), one_line(model.asset.version));
    }
    return model;
}

/// Numbers of one accessor, `components` for each of `count` elements, with every byte inside its buffer.
struct Accessed {
    const unsigned char* bytes = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;
    int type = 0;
    bool normalized = false;

    double number(std::size_t element, int component) const {
        const unsigned char* const place =
            bytes + element * stride +
            static_cast<std::size_t>(component * tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
        switch (type) {
            case TINYGLTF_COMPONENT_TYPE_BYTE:
                return signed_number<std::int8_t>(place);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                return unsigned_number<std::uint8_t>(place);
            case TINYGLTF_COMPONENT_TYPE_SHORT:
                return signed_number<std::int16_t>(place);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                return unsigned_number<std::uint16_t>(place);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                return unsigned_number<std::uint32_t>(place);
            default:
                return read<float>(place);
        }
    }

private:
    template <typename Number>
    static Number read(const unsigned char* place) {
        Number number;
        std::memcpy(&number, place, sizeof number);
        return number;
    }
    template <typename Integer>
    double signed_number(const unsigned char* place) const {
        const double number = read<Integer>(place);
        return normalized ? std::max(number / std::numeric_limits<Integer>::max(), -1.0) : number;
    }
    template <typename Integer>
    double unsigned_number(const unsigned char* place) const {
        const double number = read<Integer>(place);
        return normalized ? number / std::numeric_limits<Integer>::max() : number;
    }
};

class GltfReader {
public:
    GltfReader(const std::filesystem::path& path, const tinygltf::Model& model) : path_(path), model_(model) {}

    FileMesh read() {
        place_scene();
        if (model_.nodes.empty()) {
            for (std::size_t mesh = 0; mesh < model_.meshes.size(); ++mesh)
                placed_.emplace_back(static_cast<int>(mesh), glm::dmat4(1));
        }
        check_mesh_size(path_, 0, count_triangles());
        for (const auto& [mesh, place] : placed_) {
            for (const tinygltf::Primitive& primitive : model_.meshes[static_cast<std::size_t>(mesh)].primitives)
                add_primitive(primitive, place);
        }
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail_damaged(std::string_view what) const {
        fail("mesh '{}' is damaged: {}", path_.string(), what);
    }

    template <typename Item>
    const Item& item(const std::vector<Item>& items, int index, const char* what) const {
        if (index < 0 || static_cast<std::size_t>(index) >= items.size())
            fail_damaged(fmt::format("there is no {} {} among its {}", what, index, items.size()));
        return items[static_cast<std::size_t>(index)];
    }

    glm::dmat4 place_of(const tinygltf::Node& node) const {
        const auto numbers = [&](const std::vector<double>& given, std::size_t count, auto apply) {
            if (given.empty()) return;
            bool usable = given.size() == count;
            for (const double number : given)
                usable = usable && std::isfinite(number);
            if (!usable) fail_damaged("a node's place is not made of the numbers that it has to be made of");
            apply();
        };
        glm::dmat4 place(1);
        numbers(node.translation, 3,
                [&] { place[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1); });
        numbers(node.rotation, 4, [&] {
            const std::vector<double>& q = node.rotation;
            const glm::dquat rotation(q[3], q[0], q[1], q[2]);
            if (glm::length(rotation) > 0) place *= glm::mat4_cast(glm::normalize(rotation));
        });
        numbers(node.scale, 3, [&] {
            for (int axis = 0; axis < 3; ++axis)
                place[axis] *= node.scale[static_cast<std::size_t>(axis)];
        });
        numbers(node.matrix, 16, [&] {
            for (int number = 0; number < 16; ++number)
                place[number / 4][number % 4] = node.matrix[static_cast<std::size_t>(number)];
        });
        return place;
    }

    /// Meshes of the scene that is shown, of the first or of all nodes where none is named.
    void place_scene() {
        std::vector<std::pair<int, glm::dmat4>> left;
        std::vector<bool> seen(model_.nodes.size(), false);
        if (!model_.scenes.empty()) {
            for (const int node : item(model_.scenes, std::max(model_.defaultScene, 0), "scene").nodes)
                left.emplace_back(node, glm::dmat4(1));
        } else {
            std::vector<bool> is_child(model_.nodes.size(), false);
            for (const tinygltf::Node& node : model_.nodes) {
                for (const int child : node.children) {
                    if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                        is_child[static_cast<std::size_t>(child)] = true;
                }
            }
            for (std::size_t node = 0; node < model_.nodes.size(); ++node) {
                if (!is_child[node]) left.emplace_back(static_cast<int>(node), glm::dmat4(1));
            }
        }
        while (!left.empty()) {
            const auto [index, parent] = left.back();
            left.pop_back();
            const tinygltf::Node& node = item(model_.nodes, index, "node");
            if (seen[static_cast<std::size_t>(index)]) fail_damaged(fmt::format("node {} has two parents", index));
            seen[static_cast<std::size_t>(index)] = true;
            const glm::dmat4 place = parent * place_of(node);
            if (node.mesh >= 0) {
                item(model_.meshes, node.mesh, "mesh");
                placed_.emplace_back(node.mesh, place);
            }
            for (const int child : node.children)
                left.emplace_back(child, place);
        }
    }

    static bool has_triangles(const tinygltf::Primitive& primitive) {
        return primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
               primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    }

    /// Of corners in the order in which they are drawn.
    static std::size_t triangles_of(const tinygltf::Primitive& primitive, std::size_t corners) {
        if (primitive.mode == TINYGLTF_MODE_TRIANGLES) return corners / 3;
        return corners < 3 ? 0 : corners - 2;
    }

    const int* attribute(const tinygltf::Primitive& primitive, const char* name) const {
        const auto found = primitive.attributes.find(name);
        return found == primitive.attributes.end() ? nullptr : &found->second;
    }

    /// Before any is made: files may place one mesh very often.
    std::size_t count_triangles() const {
        std::size_t triangles = 0;
        for (const auto& [mesh, place] : placed_) {
            for (const tinygltf::Primitive& primitive : model_.meshes[static_cast<std::size_t>(mesh)].primitives) {
                const int* const positions = attribute(primitive, "POSITION");
                if (!has_triangles(primitive) || !positions) continue;
                const int corners = primitive.indices >= 0 ? primitive.indices : *positions;
                const std::size_t count = item(model_.accessors, corners, "accessor").count;
                // Vertices take memory, whether they are drawn or not.
                triangles +=
                    std::max(triangles_of(primitive, count), item(model_.accessors, *positions, "accessor").count / 3);
                if (triangles > max_file_triangles) return triangles;
            }
        }
        return triangles;
    }

    /// An accessor of one of the types given, of vectors of as many components.
    Accessed access(int index, int type, std::initializer_list<int> component_types, const char* what) const {
        const tinygltf::Accessor& accessor = item(model_.accessors, index, "accessor");
        if (accessor.sparse.isSparse) {
            fail("mesh '{}' stores its {} sparsely (accessor {}), which is not read: export it otherwise",
                 path_.string(), what, index);
        }
        if (accessor.type != type ||
            std::ranges::find(component_types, accessor.componentType) == component_types.end()) {
            fail_damaged(fmt::format("accessor {} has no numbers of a type that {} can have", index, what));
        }
        const tinygltf::BufferView& view = item(model_.bufferViews, accessor.bufferView, "buffer view");
        const tinygltf::Buffer& buffer = item(model_.buffers, view.buffer, "buffer");
        const auto size = static_cast<std::size_t>(
            tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)) *
            tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
        const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
        const std::size_t available = buffer.data.size();
        const bool view_fits = view.byteOffset <= available && view.byteLength <= available - view.byteOffset;
        const bool fits = view_fits && accessor.byteOffset <= view.byteLength && accessor.count > 0 && stride >= size &&
                          size <= view.byteLength - accessor.byteOffset &&
                          (accessor.count - 1) <= (view.byteLength - accessor.byteOffset - size) / stride;
        if (!fits) fail_damaged(fmt::format("accessor {}, of {}, reaches beyond its buffer", index, what));
        return {.bytes = buffer.data.data() + view.byteOffset + accessor.byteOffset,
                .count = accessor.count,
                .stride = stride,
                .type = accessor.componentType,
                .normalized = accessor.normalized};
    }

    /// Numbers of vertices, three for each triangle.
    std::vector<std::uint32_t> corners_of(const tinygltf::Primitive& primitive, std::size_t vertices) const {
        std::vector<std::uint32_t> order;
        if (primitive.indices < 0) {
            for (std::size_t vertex = 0; vertex < vertices; ++vertex)
                order.push_back(static_cast<std::uint32_t>(vertex));
        } else {
            const Accessed indices =
                access(primitive.indices, TINYGLTF_TYPE_SCALAR,
                       {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                        TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
                       "indices");
            for (std::size_t corner = 0; corner < indices.count; ++corner) {
                const double vertex = indices.number(corner, 0);
                if (!(vertex < static_cast<double>(vertices))) {
                    fail_damaged(
                        fmt::format("a triangle has the vertex {}, and there are {} (from 0)", vertex, vertices));
                }
                order.push_back(static_cast<std::uint32_t>(vertex));
            }
        }
        std::vector<std::uint32_t> corners;
        const std::size_t triangles = triangles_of(primitive, order.size());
        corners.reserve(3 * triangles);
        for (std::size_t triangle = 0; triangle < triangles; ++triangle) {
            std::array<std::size_t, 3> of{3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
            // As glTF 2.0 has them (3.7.2.1): each second one of a strip turns the other way.
            if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP)
                of = {triangle, triangle + 1 + triangle % 2, triangle + 2 - triangle % 2};
            if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) of = {triangle + 1, triangle + 2, 0};
            for (const std::size_t corner : of)
                corners.push_back(order[corner]);
        }
        return corners;
    }

    void add_primitive(const tinygltf::Primitive& primitive, const glm::dmat4& place) {
        const int* const position = attribute(primitive, "POSITION");
        if (!has_triangles(primitive) || !position) return;
        const auto numbers = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                              TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
                              TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
        const Accessed positions = access(*position, TINYGLTF_TYPE_VEC3, numbers, "positions");
        const std::vector<std::uint32_t> corners = corners_of(primitive, positions.count);
        const int* const uv = attribute(primitive, "TEXCOORD_0");
        if (!uv) {
            mesh_.triangles_without_uv += corners.size() / 3;
            return;
        }
        const Accessed coordinates = access(*uv, TINYGLTF_TYPE_VEC2, numbers, "texture coordinates");
        std::optional<Accessed> normals;
        if (const int* const normal = attribute(primitive, "NORMAL"))
            normals = access(*normal, TINYGLTF_TYPE_VEC3, numbers, "normals");
        if (coordinates.count != positions.count || (normals && normals->count != positions.count))
            fail_damaged("a part has not as many texture coordinates or normals as positions");

        const glm::dmat3 turn(place);
        // Where a mirror turns the winding over, the front stays the front.
        const bool mirrors = glm::determinant(turn) < 0;
        // The inverse transpose, but for a scale that only a collapsed part has not.
        const glm::dmat3 turn_normal(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]),
                                     glm::cross(turn[0], turn[1]));
        const bool is_placed = place != glm::dmat4(1);
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (std::size_t vertex = 0; vertex < positions.count; ++vertex) {
            const auto vector = [&](const Accessed& accessed) {
                return glm::dvec3(accessed.number(vertex, 0), accessed.number(vertex, 1), accessed.number(vertex, 2));
            };
            MeshVertex read{.position = glm::vec3(vector(positions)), .normal = glm::vec3(0), .uv = glm::vec2(0)};
            if (is_placed) read.position = glm::vec3(place * glm::dvec4(vector(positions), 1));
            if (normals) {
                const glm::dvec3 normal = vector(*normals);
                read.normal = file_normal(is_placed ? (mirrors ? -1.0 : 1.0) * (turn_normal * normal) : normal, mesh_);
            }
            // glTF's v run down from the top row of a picture.
            read.uv = glm::vec2(coordinates.number(vertex, 0), 1 - coordinates.number(vertex, 1));
            mesh_.vertices.push_back(read);
        }
        for (std::size_t corner = 0; corner < corners.size(); corner += 3) {
            const std::size_t second = corner + (mirrors ? 2 : 1);
            const std::size_t third = corner + (mirrors ? 1 : 2);
            mesh_.triangles.push_back({first + corners[corner], first + corners[second], first + corners[third]});
        }
    }

    const std::filesystem::path& path_;
    const tinygltf::Model& model_;
    /// Meshes and where they are.
    std::vector<std::pair<int, glm::dmat4>> placed_;
    FileMesh mesh_;
};

}  // namespace

FileMesh read_gltf_file(const std::filesystem::path& path) {
    const tinygltf::Model model = load_model(path);
    return GltfReader(path, model).read();
}

}  // namespace reliefbench
