#include "scene/surface/charts.hpp"

#include "scene/surface/vertex_places.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace reliefbench {

namespace {

/// A chart this many times as long as its seam says has no period: it overlaps itself, or the seam is no seam.
constexpr float max_periods_of_chart = 4;

/// What programs that write meshes round differently on both sides of a seam, of normals.
constexpr float normal_rounding = 1e-5f;

bool is_same_normal(const glm::vec3& a, const glm::vec3& b) {
    return glm::length(a - b) <= normal_rounding;
}

/// Sets of triangles that grow together.
class TriangleSets {
public:
    explicit TriangleSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
    }

    std::uint32_t first_of(std::uint32_t triangle) {
        while (parents_[triangle] != triangle)
            triangle = parents_[triangle] = parents_[parents_[triangle]];
        return triangle;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t one = first_of(a);
        const std::uint32_t other = first_of(b);
        parents_[std::max(one, other)] = std::min(one, other);
    }

private:
    std::vector<std::uint32_t> parents_;
};

/// A side of a triangle, its ends in the order of their numbers.
struct ChartSide {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t triangle = 0;
    /// The triangle's own vertices there.
    std::array<std::uint32_t, 2> vertices;
};

/// Sorted, so that sides between the same ends are neighbours.
std::vector<ChartSide> sorted_sides(const BaseMesh& mesh, const std::vector<std::uint32_t>& number_of) {
    std::vector<ChartSide> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::uint32_t from = mesh.triangles[triangle][corner];
            std::uint32_t to = mesh.triangles[triangle][(corner + 1) % 3];
            if (number_of[from] > number_of[to]) std::swap(from, to);
            sides.push_back({{number_of[from], number_of[to]}, static_cast<std::uint32_t>(triangle), {from, to}});
        }
    }
    std::ranges::stable_sort(sides, {}, &ChartSide::ends);
    return sides;
}

/// Calls visit(first, next) for each two neighbouring sides between the same ends.
template <typename Visit>
void for_each_pair(const std::vector<ChartSide>& sides, const Visit& visit) {
    for (std::size_t side = 1; side < sides.size(); ++side) {
        if (sides[side].ends == sides[side - 1].ends) visit(sides[side - 1], sides[side]);
    }
}

/// The period that a seam makes: the same step along u, or along v, at both of its ends; 0 where it is none.
glm::vec2 period_of_seam(const BaseMesh& mesh, const ChartSide& a, const ChartSide& b) {
    std::array<glm::vec2, 2> steps;
    for (std::size_t end = 0; end < 2; ++end) {
        const MeshVertex& here = mesh.vertices[a.vertices[end]];
        const MeshVertex& there = mesh.vertices[b.vertices[end]];
        if (!is_same_normal(here.normal, there.normal)) return glm::vec2(0);
        steps[end] = glm::abs(there.uv - here.uv);
    }
    const float rounding = 1e-5f * std::max({1.0f, steps[0].x, steps[0].y});
    const glm::vec2 change = glm::abs(steps[0] - steps[1]);
    if (change.x > rounding || change.y > rounding) return glm::vec2(0);
    if (steps[0].x > rounding && steps[0].y > rounding) return glm::vec2(0);
    return {steps[0].x > rounding ? steps[0].x : 0, steps[0].y > rounding ? steps[0].y : 0};
}

void find_chart_periods(BaseMesh& mesh, std::uint32_t charts) {
    mesh.chart_periods.assign(charts, glm::vec2(0));
    std::vector<glm::vec2> low(charts, glm::vec2(std::numeric_limits<float>::infinity()));
    std::vector<glm::vec2> high(charts, glm::vec2(-std::numeric_limits<float>::infinity()));
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const std::uint32_t chart = mesh.charts[triangle];
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
            low[chart] = glm::min(low[chart], mesh.vertices[corner].uv);
            high[chart] = glm::max(high[chart], mesh.vertices[corner].uv);
        }
    }
    for_each_pair(sorted_sides(mesh, first_in_place(mesh.vertices)), [&](const ChartSide& a, const ChartSide& b) {
        const std::uint32_t chart = mesh.charts[a.triangle];
        if (chart != mesh.charts[b.triangle]) return;
        const glm::vec2 period = period_of_seam(mesh, a, b);
        const glm::vec2 size = high[chart] - low[chart];
        for (int axis = 0; axis < 2; ++axis) {
            if (period[axis] == 0 || size[axis] > max_periods_of_chart * period[axis]) continue;
            // The shortest, where seams differ.
            float& known = mesh.chart_periods[chart][axis];
            known = known == 0 ? period[axis] : std::min(known, period[axis]);
        }
    });
}

/// Of a mesh that has its charts. Where a chart ends on the square's border only, it lies over every point of the
/// square equally often, as its triangles all turn alike: its area says how often.
bool covers_unit_square(const BaseMesh& mesh) {
    if (mesh.chart_periods.size() != 1 || mesh.chart_periods.front() != glm::vec2(0)) return false;
    const auto is_in_square = [](const MeshVertex& vertex) {
        return vertex.uv.x >= 0 && vertex.uv.x <= 1 && vertex.uv.y >= 0 && vertex.uv.y <= 1;
    };
    double area = 0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        area += chart_area(mesh, triangle);
        for (const std::uint32_t corner : mesh.triangles[triangle])
            if (!is_in_square(mesh.vertices[corner])) return false;
    }
    if (std::abs(std::abs(area) - 1) > 0.5) return false;
    const std::vector<ChartSide> sides = sorted_sides(mesh, first_alike(mesh.vertices));
    const auto is_on_border = [&](const ChartSide& side) {
        const glm::vec2 from = mesh.vertices[side.vertices[0]].uv;
        const glm::vec2 to = mesh.vertices[side.vertices[1]].uv;
        return (from.x == to.x && (to.x == 0 || to.x == 1)) || (from.y == to.y && (to.y == 0 || to.y == 1));
    };
    for (auto first = sides.begin(); first != sides.end();) {
        const auto next =
            std::find_if(first, sides.end(), [&](const ChartSide& side) { return side.ends != first->ends; });
        if (next - first > 2 || (next - first == 1 && !is_on_border(*first))) return false;
        first = next;
    }
    return true;
}

}  // namespace

void find_charts(BaseMesh& mesh) {
    TriangleSets sets(mesh.triangles.size());
    for_each_pair(sorted_sides(mesh, first_alike(mesh.vertices)), [&](const ChartSide& a, const ChartSide& b) {
        const bool turn_alike = chart_area(mesh, a.triangle) * chart_area(mesh, b.triangle) > 0;
        if (turn_alike) sets.join(a.triangle, b.triangle);
    });
    mesh.charts.assign(mesh.triangles.size(), 0);
    std::uint32_t charts = 0;
    // The first of a set has the lowest number of it.
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const std::uint32_t first = sets.first_of(triangle);
        mesh.charts[triangle] = first == triangle ? charts++ : mesh.charts[first];
    }
    find_chart_periods(mesh, charts);
    mesh.is_unit_square = covers_unit_square(mesh);
}

glm::dvec2 chart_period(const BaseMesh& mesh, std::uint32_t triangle) {
    return triangle < mesh.charts.size() ? glm::dvec2(mesh.chart_periods[mesh.charts[triangle]]) : glm::dvec2(0);
}

glm::dvec2 shortest_way(glm::dvec2 difference, glm::dvec2 period) {
    for (int axis = 0; axis < 2; ++axis) {
        if (period[axis] > 0) difference[axis] = std::remainder(difference[axis], period[axis]);
    }
    return difference;
}

std::size_t count_torn_sides(const BaseMesh& mesh) {
    std::size_t torn = 0;
    for_each_pair(sorted_sides(mesh, first_in_place(mesh.vertices)), [&](const ChartSide& a, const ChartSide& b) {
        const auto differs = [&](std::size_t end) {
            return !is_same_normal(mesh.vertices[a.vertices[end]].normal, mesh.vertices[b.vertices[end]].normal);
        };
        if (differs(0) || differs(1)) ++torn;
    });
    return torn;
}

}  // namespace reliefbench
