#pragma once

#include "scene/surface/base_mesh.hpp"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>

namespace reliefbench {

/// Sets `charts`, `chart_periods` and `is_unit_square` of a mesh that has its vertices and triangles. Triangles are of
/// one chart where they share a side with the same positions, normals and (u, v) at both ends and (u, v) turn the same
/// way on them, so that a chart nowhere folds over. Charts are numbered in the order of their first triangles.
void find_charts(BaseMesh& mesh);

/// After how much of u, and of v, the chart of a triangle meets itself again, 0 where it does not; of no_triangle 0,
/// too.
glm::dvec2 chart_period(const BaseMesh& mesh, std::uint32_t triangle);

/// How far apart two points of a chart are in (u, v), whose plain difference this is: the shortest way round where it
/// has a period.
glm::dvec2 shortest_way(glm::dvec2 difference, glm::dvec2 period);

/// Sides that two triangles share in their positions, but not in their normals: the relief tears there.
std::size_t count_torn_sides(const BaseMesh& mesh);

}  // namespace reliefbench
