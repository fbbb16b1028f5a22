#pragma once

#include "core/json.hpp"
#include "scene/surface/base_mesh.hpp"

#include <fmt/format.h>

#include <cstring>
#include <string>

namespace reliefbench {

/// A glTF asset in the making: what it says, and its one buffer.
struct GltfAsset {
    Json json;
    std::string buffer;
};

/// One mesh of one primitive with positions (accessor 0), normals (1), texture coordinates (2) and indices (3).
inline GltfAsset gltf_of(const BaseMesh& mesh) {
    GltfAsset asset;
    asset.json = parse_json(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1,
        "TEXCOORD_0": 2}, "indices": 3}]}], "bufferViews": [], "accessors": []})",
                            "gltf");
    const auto add = [&](const char* type, int component_type, std::size_t count, const auto& write) {
        const std::size_t begin = asset.buffer.size();
        for (std::size_t element = 0; element < count; ++element)
            write(element);
        asset.json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", asset.buffer.size() - begin}});
        asset.json["accessors"].push_back({{"bufferView", asset.json["bufferViews"].size() - 1},
                                           {"componentType", component_type},
                                           {"count", count},
                                           {"type", type}});
    };
    const auto put = [&](auto number) {
        char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        asset.buffer.append(bytes, sizeof number);
    };
    constexpr int float_type = 5126;
    constexpr int uint_type = 5125;
    const std::vector<MeshVertex>& vertices = mesh.vertices;
    add("VEC3", float_type, vertices.size(), [&](std::size_t vertex) {
        for (int axis = 0; axis < 3; ++axis)
            put(vertices[vertex].position[axis]);
    });
    add("VEC3", float_type, vertices.size(), [&](std::size_t vertex) {
        for (int axis = 0; axis < 3; ++axis)
            put(vertices[vertex].normal[axis]);
    });
    add("VEC2", float_type, vertices.size(), [&](std::size_t vertex) {
        put(vertices[vertex].uv.x);
        put(1 - vertices[vertex].uv.y);
    });
    add("SCALAR", uint_type, 3 * mesh.triangles.size(),
        [&](std::size_t corner) { put(mesh.triangles[corner / 3][corner % 3]); });
    asset.json["buffers"] = Json::array({{{"byteLength", asset.buffer.size()}}});
    return asset;
}

inline std::string as_glb(const GltfAsset& asset) {
    std::string json = asset.json.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string binary = asset.buffer;
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string bytes = "glTF";
    const auto put = [&](std::size_t number) {
        for (int byte = 0; byte < 4; ++byte)
            bytes += static_cast<char>(number >> (8 * byte));
    };
    put(2);
    put(12 + 8 + json.size() + 8 + binary.size());
    put(json.size());
    bytes += "JSON" + json;
    put(binary.size());
    bytes += std::string("BIN\0", 4) + binary;
    return bytes;
}

/// With the buffer in a file of its own.
inline std::string as_gltf(GltfAsset asset, const std::string& uri) {
    asset.json["buffers"][0]["uri"] = uri;
    return asset.json.dump();
}

inline std::string as_obj(const BaseMesh& mesh, bool with_normals = true) {
    std::string text = "# a mesh\n";
    for (const MeshVertex& vertex : mesh.vertices) {
        text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", vertex.position.x, vertex.position.y, vertex.position.z);
        text += fmt::format("vt {:.9g} {:.9g}\n", vertex.uv.x, vertex.uv.y);
        text += fmt::format("vn {:.9g} {:.9g} {:.9g}\n", vertex.normal.x, vertex.normal.y, vertex.normal.z);
    }
    for (const BaseMesh::Triangle& triangle : mesh.triangles) {
        text += "f";
        for (const std::uint32_t corner : triangle)
            text += with_normals ? fmt::format(" {0}/{0}/{0}", corner + 1) : fmt::format(" {0}/{0}", corner + 1);
        text += "\n";
    }
    return text;
}

}  // namespace reliefbench
