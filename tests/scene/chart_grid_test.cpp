#include "scene/surface/chart_grid.hpp"

#include "core/random.hpp"
#include "scene/surface/charts.hpp"
#include "scene/surface/generated_base.hpp"
#include "support/closed_cylinder.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace reliefbench {
namespace {

using testing::Each;
using testing::ElementsAre;

/// Whether the triangle lies over (u, v), with what rounding may make of its sides.
bool lies_over(const BaseMesh& mesh, std::size_t triangle, glm::dvec2 uv) {
    const BaseMesh::Triangle& corners = mesh.triangles[triangle];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec2 from(mesh.vertices[corners[corner]].uv);
        const glm::dvec2 side = glm::dvec2(mesh.vertices[corners[(corner + 1) % 3]].uv) - from;
        const glm::dvec2 to_point = uv - from;
        const double inside = (side.x * to_point.y - side.y * to_point.x) / (2 * chart_area(mesh, triangle));
        if (inside < -1e-6) return false;
    }
    return true;
}

TEST(Charts, AGeneratedBaseIsOneWithoutPeriods) {
    BaseMesh mesh = generate_base({.kind = BaseSource::Kind::sphere, .curvature = 2, .segments = 9});
    EXPECT_THAT(mesh.charts, Each(0U));
    EXPECT_THAT(mesh.chart_periods, ElementsAre(glm::vec2(0)));
    const std::vector<std::uint32_t> charts = mesh.charts;
    find_charts(mesh);
    EXPECT_EQ(mesh.charts, charts);
    EXPECT_THAT(mesh.chart_periods, ElementsAre(glm::vec2(0)));
    EXPECT_EQ(count_torn_sides(mesh), 0U);
}

TEST(Charts, VerticesNeedNotBeSharedToBeAlike) {
    BaseMesh mesh = generate_base({.kind = BaseSource::Kind::saddle, .segments = 4});
    BaseMesh soup = mesh;
    soup.vertices.clear();
    for (BaseMesh::Triangle& triangle : soup.triangles) {
        for (std::uint32_t& corner : triangle) {
            soup.vertices.push_back(mesh.vertices[corner]);
            corner = static_cast<std::uint32_t>(soup.vertices.size() - 1);
        }
    }
    find_charts(soup);
    EXPECT_EQ(soup.charts, mesh.charts);
}

TEST(Charts, EndWhereNormalsOrCoordinatesSplitAndWhereTheyTurnOver) {
    // Two quads in a row along x, each of two triangles.
    const auto two_quads = [](float u_of_last, float last_normal_x) {
        BaseMesh mesh;
        const glm::vec3 up(0, 0, 1);
        for (const float y : {0.0f, 1.0f}) {
            mesh.vertices.push_back({{0, y, 0}, up, {0, y}});
            mesh.vertices.push_back({{1, y, 0}, up, {1, y}});
            mesh.vertices.push_back({{1, y, 0}, glm::vec3(last_normal_x, 0, 1), {1, y}});
            mesh.vertices.push_back({{2, y, 0}, up, {u_of_last, y}});
        }
        mesh.triangles = {{0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6}};
        find_charts(mesh);
        return mesh;
    };
    EXPECT_THAT(two_quads(2, 0).charts, ElementsAre(0, 0, 0, 0));
    const BaseMesh torn = two_quads(2, 0.1f);
    EXPECT_THAT(torn.charts, ElementsAre(0, 0, 1, 1));
    EXPECT_EQ(count_torn_sides(torn), 1U);
    const BaseMesh mirrored = two_quads(0, 0);
    EXPECT_THAT(mirrored.charts, ElementsAre(0, 0, 1, 1));
    EXPECT_EQ(count_torn_sides(mirrored), 0U);
}

TEST(Charts, OneThatMeetsItselfAlongASeamHasAPeriod) {
    for (const double slant : {0.0, 0.375}) {
        BaseMesh mesh = closed_cylinder(12, 4, 3, slant);
        find_charts(mesh);
        EXPECT_THAT(mesh.charts, Each(0U));
        EXPECT_THAT(mesh.chart_periods, ElementsAre(glm::vec2(3, 0)));
    }
    // Another step of u at each end of the seam is no period.
    BaseMesh mesh = closed_cylinder(12, 1);
    mesh.vertices.back().uv.x = 1.25f;
    find_charts(mesh);
    EXPECT_THAT(mesh.chart_periods, ElementsAre(glm::vec2(0)));
}

TEST(Charts, CoverTheUnitSquareWhereTheyEndOnItsBorderOnly) {
    const BaseMesh whole = generate_base({.kind = BaseSource::Kind::saddle, .segments = 5});
    const auto covers = [](BaseMesh mesh) {
        find_charts(mesh);
        return mesh.is_unit_square;
    };
    EXPECT_TRUE(covers(whole));
    BaseMesh turned = whole;
    for (MeshVertex& vertex : turned.vertices)
        vertex.uv.x = 1 - vertex.uv.x;
    EXPECT_TRUE(covers(turned));
    BaseMesh with_hole = whole;
    with_hole.triangles.erase(with_hole.triangles.begin() + 24);
    EXPECT_FALSE(covers(with_hole));
    BaseMesh smaller = whole;
    BaseMesh beyond = whole;
    for (std::size_t vertex = 0; vertex < whole.vertices.size(); ++vertex) {
        smaller.vertices[vertex].uv *= 0.99F;
        beyond.vertices[vertex].uv += 0.125F;
    }
    EXPECT_FALSE(covers(smaller));
    EXPECT_FALSE(covers(beyond));
    EXPECT_FALSE(covers(closed_cylinder(12, 4))) << "it goes on past the square's side";
    BaseMesh twice = whole;
    const auto first = static_cast<std::uint32_t>(whole.vertices.size());
    for (MeshVertex vertex : whole.vertices) {
        vertex.position.z += 1;
        twice.vertices.push_back(vertex);
    }
    for (const BaseMesh::Triangle& triangle : whole.triangles)
        twice.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    EXPECT_FALSE(covers(twice)) << "two charts";
}

TEST(Charts, ASeamMayBeRoundedDifferentlyOnBothSides) {
    BaseMesh mesh = closed_cylinder(12, 4, 3);
    for (std::size_t row = 0; row <= 4; ++row) {
        MeshVertex& end = mesh.vertices[13 * row + 12];
        end.position.z += 1e-8f;
        end.normal = {0, std::cos(1e-7f), std::sin(1e-7f)};
    }
    find_charts(mesh);
    EXPECT_THAT(mesh.chart_periods, ElementsAre(glm::vec2(3, 0)));
    EXPECT_EQ(count_torn_sides(mesh), 0U);
}

TEST(ChartGrid, FindsTheTriangleOverEachPoint) {
    const BaseMesh mesh = generate_base({.kind = BaseSource::Kind::cylinder, .segments = 17});
    const ChartGrid grid = make_chart_grid(mesh);
    Random random(7);
    for (int point = 0; point < 5000; ++point) {
        const glm::dvec2 uv(random.uniform(), random.uniform());
        const std::uint32_t found = find_triangle(mesh, grid, 0, uv);
        ASSERT_NE(found, no_triangle);
        EXPECT_TRUE(lies_over(mesh, found, uv));
    }
    // Vertices, sides and the border belong to it.
    for (int row = 0; row <= 34; ++row) {
        for (int column = 0; column <= 34; ++column)
            EXPECT_NE(find_triangle(mesh, grid, 0, glm::dvec2(column, row) / 34.0), no_triangle);
    }
    for (const glm::dvec2 beside : {glm::dvec2(-1e-4, 0.5), glm::dvec2(0.5, 1.0001), glm::dvec2(7, -3)})
        EXPECT_EQ(find_triangle(mesh, grid, 0, beside), no_triangle);
}

TEST(ChartGrid, KeepsChartsOverTheSameCoordinatesApart) {
    BaseMesh mesh = generate_base({.kind = BaseSource::Kind::cylinder, .segments = 3});
    const BaseMesh other = generate_base({.kind = BaseSource::Kind::saddle, .segments = 5});
    const auto first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const BaseMesh::Triangle& triangle : other.triangles)
        mesh.triangles.push_back({triangle[0] + first_vertex, triangle[1] + first_vertex, triangle[2] + first_vertex});
    find_charts(mesh);
    const ChartGrid grid = make_chart_grid(mesh);
    ASSERT_EQ(grid.charts.size(), 2U);
    EXPECT_LT(find_triangle(mesh, grid, 0, {0.4, 0.3}), 18U);
    EXPECT_GE(find_triangle(mesh, grid, 1, {0.4, 0.3}), 18U);
}

TEST(ChartGrid, WrapsWhereAChartHasAPeriod) {
    for (const double slant : {0.0, 0.375, 2.5}) {
        BaseMesh mesh = closed_cylinder(12, 4, 1, slant);
        find_charts(mesh);
        ASSERT_THAT(mesh.chart_periods, ElementsAre(glm::vec2(1, 0)));
        const ChartGrid grid = make_chart_grid(mesh);
        for (int step = 0; step < 200; ++step) {
            const glm::dvec2 uv(slant * 0.6 + (step + 0.123) / 201, 0.6);
            const std::uint32_t found = find_triangle(mesh, grid, 0, uv);
            ASSERT_NE(found, no_triangle);
            EXPECT_TRUE(lies_over(mesh, found, uv));
            EXPECT_EQ(find_triangle(mesh, grid, 0, uv + glm::dvec2(5, 0)), found);
            EXPECT_EQ(find_triangle(mesh, grid, 0, uv - glm::dvec2(3, 0)), found);
        }
        EXPECT_EQ(find_triangle(mesh, grid, 0, {0.5, 1.01}), no_triangle);
    }
}

TEST(ChartGrid, StaysSmallOverSlivers) {
    // Slanted strips, each a thousand times as long as wide.
    BaseMesh mesh;
    constexpr std::uint32_t strips = 2000;
    for (std::uint32_t strip = 0; strip <= strips; ++strip) {
        const float place = static_cast<float>(strip) / strips;
        mesh.vertices.push_back({{place, 0, 0}, {0, 0, 1}, {place, 0}});
        mesh.vertices.push_back({{place, 1, 0}, {0, 0, 1}, {place + 1, 1}});
    }
    for (std::uint32_t strip = 0; strip < strips; ++strip) {
        mesh.triangles.push_back({2 * strip, 2 * strip + 2, 2 * strip + 1});
        mesh.triangles.push_back({2 * strip + 1, 2 * strip + 2, 2 * strip + 3});
    }
    find_charts(mesh);
    const ChartGrid grid = make_chart_grid(mesh);
    EXPECT_LE(grid.cell_triangles.size(), 8 * mesh.triangles.size());
    for (const glm::dvec2 uv : {glm::dvec2(0.5, 0.25), glm::dvec2(1.01, 0.5), glm::dvec2(1.99, 0.9999)}) {
        const std::uint32_t found = find_triangle(mesh, grid, 0, uv);
        ASSERT_NE(found, no_triangle);
        EXPECT_TRUE(lies_over(mesh, found, uv));
    }
}

}  // namespace
}  // namespace reliefbench
