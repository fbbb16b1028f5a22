#include "scene/surface/chart_grid.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

constexpr std::uint32_t max_cells_of_side = 1024;
/// Of barycentric coordinates: what rounding may leave between two triangles.
constexpr double gap = 1e-6;

using ChartCorners = std::array<glm::dvec2, 3>;

ChartCorners chart_corners(const BaseMesh& mesh, std::size_t triangle) {
    const BaseMesh::Triangle& corners = mesh.triangles[triangle];
    return {glm::dvec2(mesh.vertices[corners[0]].uv), glm::dvec2(mesh.vertices[corners[1]].uv),
            glm::dvec2(mesh.vertices[corners[2]].uv)};
}

double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// The least of the barycentric coordinates: negative outside.
double depth_inside(const ChartCorners& corners, glm::dvec2 uv) {
    const double area = doubled_area(corners[0], corners[1], corners[2]);
    return std::min({doubled_area(corners[1], corners[2], uv), doubled_area(corners[2], corners[0], uv),
                     doubled_area(corners[0], corners[1], uv)},
                    [&](double left, double right) { return left / area < right / area; }) /
           area;
}

struct ChartExtent {
    glm::vec2 low{std::numeric_limits<float>::infinity()};
    glm::vec2 high{-std::numeric_limits<float>::infinity()};
    std::size_t triangles = 0;
};

/// About as many cells as triangles, about square.
ChartCells cells_over(const ChartExtent& extent, double triangles_of_cell) {
    ChartCells cells{.low = {0, 0}, .cells_per_uv = {0, 0}, .cells = {1, 1}};
    if (extent.triangles == 0) return cells;
    cells.low = extent.low;
    const glm::dvec2 size = glm::dvec2(extent.high) - glm::dvec2(extent.low);
    const double side = std::sqrt(size.x * size.y * triangles_of_cell / static_cast<double>(extent.triangles));
    for (int axis = 0; axis < 2; ++axis) {
        cells.cells[axis] = static_cast<std::uint32_t>(std::clamp(size[axis] / side, 1.0, double(max_cells_of_side)));
        cells.cells_per_uv[axis] = static_cast<float>(cells.cells[axis] / size[axis]);
    }
    return cells;
}

std::uint32_t cell_along(double cell, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(cell), 0.0, double(count - 1)));
}

/// Calls visit(cell) for every cell that the triangle reaches into, in cell units and with the margin.
template <typename Visit>
void for_each_cell(const ChartCells& chart, const ChartCorners& corners, const Visit& visit) {
    ChartCorners scaled;
    double margin = 1e-3;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        scaled[corner] = (corners[corner] - glm::dvec2(chart.low)) * glm::dvec2(chart.cells_per_uv);
        for (int axis = 0; axis < 2; ++axis) {
            const double rounding = std::abs(corners[corner][axis]) * double(chart.cells_per_uv[axis]) * 1e-6;
            margin = std::max(margin, rounding);
        }
    }
    const glm::dvec2 low = glm::min(glm::min(scaled[0], scaled[1]), scaled[2]) - margin;
    const glm::dvec2 high = glm::max(glm::max(scaled[0], scaled[1]), scaled[2]) + margin;
    const double turn = doubled_area(scaled[0], scaled[1], scaled[2]) < 0 ? -1 : 1;
    // The corner of a cell that is furthest inside each side decides whether the cell lies beyond it.
    const auto is_beyond = [&](const glm::dvec2& from, const glm::dvec2& to, double x, double y) {
        const glm::dvec2 side = (to - from) * turn;
        const double inwards_x = (side.y < 0 ? x + 1 + margin : x - margin) - from.x;
        const double inwards_y = (side.x > 0 ? y + 1 + margin : y - margin) - from.y;
        return side.x * inwards_y - side.y * inwards_x < 0;
    };
    for (std::uint32_t y = cell_along(low.y, chart.cells.y); y <= cell_along(high.y, chart.cells.y); ++y) {
        for (std::uint32_t x = cell_along(low.x, chart.cells.x); x <= cell_along(high.x, chart.cells.x); ++x) {
            if (is_beyond(scaled[0], scaled[1], x, y) || is_beyond(scaled[1], scaled[2], x, y) ||
                is_beyond(scaled[2], scaled[0], x, y)) {
                continue;
            }
            visit(chart.first_cell + y * chart.cells.x + x);
        }
    }
}

}  // namespace

ChartGrid make_chart_grid(const BaseMesh& mesh) {
    ChartGrid grid;
    std::vector<ChartExtent> extents(mesh.chart_periods.size());
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
        ChartExtent& extent = extents[mesh.charts[triangle]];
        ++extent.triangles;
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
            extent.low = glm::min(extent.low, mesh.vertices[corner].uv);
            extent.high = glm::max(extent.high, mesh.vertices[corner].uv);
        }
    }
    // Slivers reach into many cells: where there are too many entries, the cells get larger.
    for (double triangles_of_cell = 1;; triangles_of_cell *= 4) {
        grid.charts.clear();
        std::uint32_t cells = 0;
        for (const ChartExtent& extent : extents) {
            grid.charts.push_back(cells_over(extent, triangles_of_cell));
            grid.charts.back().first_cell = cells;
            cells += grid.charts.back().cells.x * grid.charts.back().cells.y;
        }
        grid.cell_starts.assign(std::size_t{cells} + 1, 0);
        const auto for_each_entry = [&](const auto& visit) {
            for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
                for_each_cell(grid.charts[mesh.charts[triangle]], chart_corners(mesh, triangle),
                              [&](std::uint32_t cell) { visit(cell, triangle); });
            }
        };
        std::size_t entries = 0;
        for_each_entry([&](std::uint32_t cell, std::uint32_t /*triangle*/) {
            ++grid.cell_starts[cell + 1];
            ++entries;
        });
        if (entries > triangles * max_entries_of_triangle && cells > extents.size()) continue;
        for (std::size_t cell = 0; cell < cells; ++cell)
            grid.cell_starts[cell + 1] += grid.cell_starts[cell];
        grid.cell_triangles.resize(entries);
        std::vector<std::uint32_t> next(grid.cell_starts.begin(), grid.cell_starts.end() - 1);
        for_each_entry(
            [&](std::uint32_t cell, std::uint32_t triangle) { grid.cell_triangles[next[cell]++] = triangle; });
        return grid;
    }
}

glm::dvec2 wrapped_into_chart(glm::dvec2 uv, glm::dvec2 low, glm::dvec2 period) {
    for (int axis = 0; axis < 2; ++axis) {
        if (period[axis] > 0) uv[axis] -= std::floor((uv[axis] - low[axis]) / period[axis]) * period[axis];
    }
    return uv;
}

std::uint32_t find_triangle(const BaseMesh& mesh, const ChartGrid& grid, std::uint32_t chart, glm::dvec2 uv) {
    assert(chart < grid.charts.size());
    const ChartCells& cells = grid.charts[chart];
    const glm::dvec2 period(mesh.chart_periods[chart]);
    const glm::dvec2 first = wrapped_into_chart(uv, glm::dvec2(cells.low), period);
    std::uint32_t nearest = no_triangle;
    double nearest_depth_inside = -gap;
    // A chart whose seam runs aslant is wider than its period.
    const auto look_at = [&](glm::dvec2 place) {
        const glm::dvec2 cell = (place - glm::dvec2(cells.low)) * glm::dvec2(cells.cells_per_uv);
        const std::uint32_t index =
            cells.first_cell + cell_along(cell.y, cells.cells.y) * cells.cells.x + cell_along(cell.x, cells.cells.x);
        for (std::uint32_t entry = grid.cell_starts[index]; entry < grid.cell_starts[index + 1]; ++entry) {
            const std::uint32_t triangle = grid.cell_triangles[entry];
            const double depth = depth_inside(chart_corners(mesh, triangle), place);
            if (depth <= nearest_depth_inside) continue;
            nearest = triangle;
            nearest_depth_inside = depth;
            if (depth >= 0) return true;
        }
        return false;
    };
    const glm::dvec2 size = glm::dvec2(cells.cells) / glm::max(glm::dvec2(cells.cells_per_uv), glm::dvec2(1e-300));
    const auto last = [&](int axis) { return cells.low[axis] + size[axis] * (1 + gap); };
    for (double v = first.y;; v += period.y) {
        for (double u = first.x;; u += period.x) {
            if (look_at({u, v})) return nearest;
            if (!(period.x > 0) || u + period.x > last(0)) break;
        }
        if (!(period.y > 0) || v + period.y > last(1)) break;
    }
    return nearest;
}

}  // namespace reliefbench
