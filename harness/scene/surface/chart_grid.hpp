#pragma once

#include "scene/surface/base_mesh.hpp"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace reliefbench {

/// Over the bounding box of one chart's (u, v): cells.x × cells.y equal cells. (u, v) is in the cell
/// floor((uv − low)·cells_per_uv), clamped; cells stand row by row, those of low v first. Of 32 bytes, as a shader's
/// storage buffer of structures has them.
struct ChartCells {
    glm::vec2 low;
    glm::vec2 cells_per_uv;
    glm::uvec2 cells;
    /// Of ChartGrid::cell_starts, of this chart's first cell.
    std::uint32_t first_cell = 0;
    std::uint32_t unused = 0;
};

/// A grid lists no more than this for each triangle of the mesh, and has about as many cells as triangles.
inline constexpr std::size_t max_entries_of_triangle = 8;

/// Which triangles of a chart lie over a point (u, v): plain arrays, which go to the device as they are.
struct ChartGrid {
    /// By chart.
    std::vector<ChartCells> charts;
    /// The cell c lists cell_triangles[cell_starts[c]] to before cell_starts[c + 1], in ascending order; all that reach
    /// into it, with a margin for single precision.
    std::vector<std::uint32_t> cell_starts;
    std::vector<std::uint32_t> cell_triangles;
};

ChartGrid make_chart_grid(const BaseMesh& mesh);

/// The triangle of the chart over (u, v), which is moved by the chart's periods into its range: the first that has it,
/// or where rounding leaves it between two the nearest; no_triangle beside the chart.
std::uint32_t find_triangle(const BaseMesh& mesh, const ChartGrid& grid, std::uint32_t chart, glm::dvec2 uv);

/// Takes (u, v) by whole periods of a chart, where it has any, to where its bounding box begins at `low`.
glm::dvec2 wrapped_into_chart(glm::dvec2 uv, glm::dvec2 low, glm::dvec2 period);

}  // namespace reliefbench
