#include "scene/surface/vertex_places.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <unordered_map>

namespace reliefbench {

namespace {

constexpr double place_rounding = 0x1p-20;

using VertexKey = std::array<float, 8>;

struct VertexKeyHash {
    std::size_t operator()(const VertexKey& key) const {
        std::size_t hash = 0;
        for (const float number : key)
            hash = hash * 1099511628211u + std::bit_cast<std::uint32_t>(number);
        return hash ^ (hash >> 29u);
    }
};

/// By vertex, the first with the same key.
template <typename KeyOf>
std::vector<std::uint32_t> first_with_key(std::span<const MeshVertex> vertices, const KeyOf& key_of) {
    std::unordered_map<VertexKey, std::uint32_t, VertexKeyHash> first_of;
    first_of.reserve(vertices.size());
    std::vector<std::uint32_t> first;
    first.reserve(vertices.size());
    for (const MeshVertex& vertex : vertices) {
        VertexKey key = key_of(vertex);
        // −0 is 0.
        for (float& number : key)
            number += 0;
        first.push_back(first_of.emplace(key, static_cast<std::uint32_t>(first.size())).first->second);
    }
    return first;
}

}  // namespace

PositionBounds position_bounds(std::span<const MeshVertex> vertices) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    PositionBounds bounds{glm::dvec3(infinity), glm::dvec3(-infinity)};
    for (const MeshVertex& vertex : vertices) {
        bounds.low = glm::min(bounds.low, glm::dvec3(vertex.position));
        bounds.high = glm::max(bounds.high, glm::dvec3(vertex.position));
    }
    return bounds;
}

std::vector<std::uint32_t> first_in_place(std::span<const MeshVertex> vertices) {
    const PositionBounds bounds = position_bounds(vertices);
    const glm::dvec3 size = bounds.high - bounds.low;
    const float step = static_cast<float>(place_rounding * std::max({size.x, size.y, size.z}));
    return first_with_key(vertices, [step](const MeshVertex& vertex) {
        const glm::vec3 place = step > 0 ? glm::round(vertex.position / step) : vertex.position;
        return VertexKey{place.x, place.y, place.z};
    });
}

std::vector<std::uint32_t> first_alike(std::span<const MeshVertex> vertices) {
    return first_with_key(vertices, [](const MeshVertex& vertex) {
        return VertexKey{vertex.position.x, vertex.position.y, vertex.position.z, vertex.normal.x,
                         vertex.normal.y,   vertex.normal.z,   vertex.uv.x,       vertex.uv.y};
    });
}

}  // namespace reliefbench
