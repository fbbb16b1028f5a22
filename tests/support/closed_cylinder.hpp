#pragma once

#include "scene/surface/base_mesh.hpp"

#include <cmath>
#include <numbers>

namespace reliefbench {

/// Of radius 1/2 about the x axis, open at its ends: u runs `periods` times round it, v along it, and the seam has its
/// vertices twice, `slant` in u further at v = 1. Without charts.
inline BaseMesh closed_cylinder(int around, int along, double periods = 1, double slant = 0) {
    BaseMesh mesh;
    mesh.name = "closed cylinder";
    for (int row = 0; row <= along; ++row) {
        for (int column = 0; column <= around; ++column) {
            const double angle = 2 * std::numbers::pi * (column % around) / around;
            const double v = static_cast<double>(row) / along;
            const glm::vec3 normal(0, std::cos(angle), std::sin(angle));
            mesh.vertices.push_back({glm::vec3(v - 0.5, normal.y / 2, normal.z / 2), normal,
                                     glm::vec2(periods * column / around + slant * v, v)});
        }
    }
    const auto per_row = static_cast<std::uint32_t>(around + 1);
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(along); ++row) {
        for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(around); ++column) {
            const std::uint32_t corner = row * per_row + column;
            mesh.triangles.push_back({corner, corner + 1, corner + per_row + 1});
            mesh.triangles.push_back({corner, corner + per_row + 1, corner + per_row});
        }
    }
    return mesh;
}

}  // namespace reliefbench
