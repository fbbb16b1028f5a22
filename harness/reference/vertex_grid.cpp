#include "reference/vertex_grid.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"

#include <cassert>
#include <cmath>

namespace reliefbench {
namespace {

/// Three gigabytes of vertices.
constexpr double max_vertices = 1 << 28;

}  // namespace

VertexGrid enclosing_grid(const HeightMap& map, const Relief& relief, glm::dvec2 low, glm::dvec2 high,
                          int subdivision) {
    assert(subdivision >= 1);
    const double width = relief.tiling * map.width();
    const double height = relief.tiling * map.height();
    const double left = std::floor(low.x * width - 0.5);
    const double right = std::ceil(high.x * width - 0.5);
    const double bottom = std::floor(low.y * height - 0.5);
    const double top = std::ceil(high.y * height - 0.5);
    const double columns = (right - left) * subdivision + 1;
    const double rows = (top - bottom) * subdivision + 1;
    if (columns * rows > max_vertices) {
        fail(
            "a mesh of the height map '{}' with subdivision {} and tiling {} would have {:.3g} vertices, at most "
            "{:.3g} "
            "are possible: lower the subdivision, the tiling or the map's size, or use the exact truth",
            map.name, subdivision, relief.tiling, columns * rows, max_vertices);
    }
    return {static_cast<int>(left), static_cast<int>(bottom), static_cast<int>(columns), static_cast<int>(rows),
            subdivision};
}

void displace(const HeightMap& map, const Relief& relief, const VertexGrid& grid, std::span<Vertex> vertices) {
    assert(vertices.size() >= grid.vertices());
    constexpr std::size_t rows_per_task = 16;
    parallel_for(static_cast<std::size_t>(grid.rows), rows_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const double v = (grid.first_row + static_cast<double>(row) / grid.subdivision + 0.5) / map.height();
            for (int column = 0; column < grid.columns; ++column) {
                const double u =
                    (grid.first_column + static_cast<double>(column) / grid.subdivision + 0.5) / map.width();
                const glm::dvec3 point = surface_point(relief, u / relief.tiling, v / relief.tiling, map.sample(u, v));
                vertices[row * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column)] = {
                    static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
            }
        }
    });
}

}  // namespace reliefbench
