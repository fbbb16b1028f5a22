#pragma once

#include "scene/surface/base_mesh.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace reliefbench {

/// Of positions; of none, low is above high.
struct PositionBounds {
    glm::dvec3 low;
    glm::dvec3 high;
};

PositionBounds position_bounds(std::span<const MeshVertex> vertices);

/// By vertex, the first that stands in the same place. Files have a vertex several times for the sake of its (u, v) or
/// its normal, and programs that write them round it differently on both sides of a seam: places are the same up to
/// 2⁻²⁰ of the mesh's size.
std::vector<std::uint32_t> first_in_place(std::span<const MeshVertex> vertices);

/// By vertex, the first that has the same numbers in everything.
std::vector<std::uint32_t> first_alike(std::span<const MeshVertex> vertices);

}  // namespace reliefbench
