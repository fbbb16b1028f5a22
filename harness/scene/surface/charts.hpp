#pragma once

#include "scene/surface/base_mesh.hpp"

#include <cstddef>

namespace reliefbench {

/// Sets `charts` and `chart_periods` of a mesh that has its vertices and triangles. Triangles are of one chart where
/// they share a side with the same positions, normals and (u, v) at both ends and (u, v) turn the same way on them, so
/// that a chart nowhere folds over. Charts are numbered in the order of their first triangles.
void find_charts(BaseMesh& mesh);

/// Sides that two triangles share in their positions, but not in their normals: the relief tears there.
std::size_t count_torn_sides(const BaseMesh& mesh);

}  // namespace reliefbench
