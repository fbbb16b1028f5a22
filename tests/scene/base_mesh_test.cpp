#include "scene/surface/base_mesh.hpp"

#include "scene/relief.hpp"
#include "scene/surface/generated_base.hpp"
#include "scene/surface/mesh_view.hpp"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace reliefbench {
namespace {

using Kind = BaseSource::Kind;
/// Of the floats that vertices are.
constexpr double float_rounding = 1e-7;

void expect_equal(const glm::dvec3& actual, const glm::dvec3& expected, double bound) {
    EXPECT_LE(glm::distance(actual, expected), bound) << actual.x << " " << actual.y << " " << actual.z << " for "
                                                      << expected.x << " " << expected.y << " " << expected.z;
}

/// Checks each vertex of a generated base, and that its normals are those of the surface that the formula gives.
void expect_surface(const BaseSource& source, const std::function<glm::dvec3(double a, double b)>& surface) {
    const BaseMesh mesh = generate_base(source);
    const auto per_side = static_cast<std::size_t>(source.segments) + 1;
    ASSERT_EQ(mesh.vertices.size(), per_side * per_side);
    ASSERT_EQ(mesh.triangles.size(), 2 * static_cast<std::size_t>(source.segments * source.segments));
    ASSERT_EQ(mesh.charts.size(), mesh.triangles.size());
    for (const MeshVertex& vertex : mesh.vertices) {
        const double a = static_cast<double>(vertex.uv.x) - 0.5;
        const double b = static_cast<double>(vertex.uv.y) - 0.5;
        expect_equal(glm::dvec3(vertex.position), surface(a, b), float_rounding);
        constexpr double step = 1e-5;
        const glm::dvec3 along_a = surface(a + step, b) - surface(a - step, b);
        const glm::dvec3 along_b = surface(a, b + step) - surface(a, b - step);
        expect_equal(glm::dvec3(vertex.normal), glm::normalize(glm::cross(along_a, along_b)), 1e-6);
        EXPECT_NEAR(glm::length(glm::dvec3(vertex.normal)), 1, float_rounding);
    }
    const MeshVertex& centre = mesh.vertices[mesh.vertices.size() / 2];
    expect_equal(glm::dvec3(centre.position), glm::dvec3(0.0), 0);
    expect_equal(glm::dvec3(centre.normal), glm::dvec3(0, 0, 1), 0);
}

TEST(GeneratedBase, IsTheSurfaceOfItsFormula) {
    for (const double k : {-3.0, -0.5, 0.5, 1.0, 4.0}) {
        expect_surface({.kind = Kind::cylinder, .curvature = k, .segments = 8}, [k](double a, double b) {
            return glm::dvec3(a, std::sin(k * b) / k, (std::cos(k * b) - 1) / k);
        });
        expect_surface({.kind = Kind::sphere, .curvature = k, .segments = 8}, [k](double a, double b) {
            const double r = std::hypot(a, b);
            if (r == 0) return glm::dvec3(0.0);
            return glm::dvec3(std::sin(k * r) * a / (k * r), std::sin(k * r) * b / (k * r), (std::cos(k * r) - 1) / k);
        });
        expect_surface({.kind = Kind::saddle, .curvature = k, .segments = 8},
                       [k](double a, double b) { return glm::dvec3(a, b, k * (a * a - b * b) / 2); });
    }
}

TEST(GeneratedBase, IsThePlaneWithoutCurvature) {
    for (const Kind kind : {Kind::cylinder, Kind::sphere, Kind::saddle}) {
        for (const double curvature : {0.0, 1e-9}) {
            expect_surface({.kind = kind, .curvature = curvature, .segments = 8},
                           [](double a, double b) { return glm::dvec3(a, b, 0); });
        }
    }
}

TEST(GeneratedBase, TrianglesFaceTheSideThatIsSeen) {
    for (const Kind kind : {Kind::cylinder, Kind::sphere, Kind::saddle}) {
        const BaseMesh mesh = generate_base({.kind = kind, .curvature = 2, .segments = 8});
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            const BaseTriangle of = base_triangle(mesh, triangle);
            EXPECT_GT(glm::dot(of.facet_normal, of.linear_normal(mesh.vertices[mesh.triangles[triangle][0]].uv)), 0.9);
            EXPECT_NEAR(chart_area(mesh, triangle), 1.0 / 128, 1e-9);
        }
    }
}

/// Skewed and stretched, with normals that lean apart.
BaseMesh leaning_triangle() {
    const auto normal = [](float x, float y) { return glm::normalize(glm::vec3(x, y, 1)); };
    BaseMesh mesh;
    mesh.vertices = {{{0.1F, 0, 0.05F}, normal(-0.2F, 0.1F), {0.25F, 0.5F}},
                     {{0.7F, 0.1F, 0}, normal(0.3F, 0), {1.5F, 0.75F}},
                     {{0.3F, 0.5F, -0.1F}, normal(0, 0.4F), {0.5F, 2}}};
    mesh.triangles = {{0, 1, 2}};
    mesh.charts = {0};
    return mesh;
}

TEST(BaseTriangle, HasTheCornersOfItsMesh) {
    const BaseMesh mesh = leaning_triangle();
    const BaseTriangle triangle = base_triangle(mesh, 0);
    for (const MeshVertex& vertex : mesh.vertices) {
        const glm::dvec2 uv(vertex.uv);
        expect_equal(triangle.point(uv), glm::dvec3(vertex.position), 1e-14);
        expect_equal(triangle.linear_normal(uv), glm::dvec3(vertex.normal), 1e-14);
    }
    EXPECT_NEAR(glm::dot(triangle.facet_normal, triangle.along_u), 0, 1e-14);
    EXPECT_NEAR(glm::dot(triangle.facet_normal, triangle.along_v), 0, 1e-14);
    EXPECT_GT(triangle.facet_normal.z, 0.5);
}

TEST(BaseTriangle, NormalsOfTheReliefAreThoseOfItsPoints) {
    BaseMesh mesh = leaning_triangle();
    for (const bool is_mirrored : {false, true}) {
        if (is_mirrored) {
            for (MeshVertex& vertex : mesh.vertices)
                vertex.uv.x = -vertex.uv.x;
        }
        const BaseTriangle triangle = base_triangle(mesh, 0);
        EXPECT_EQ(chart_area(mesh, 0) < 0, is_mirrored);
        const double turn = is_mirrored ? -1 : 1;
        const auto above = [](glm::dvec2 uv) { return -0.3 + 0.2 * uv.x - 0.1 * uv.x * uv.y; };
        const auto surface = [&](glm::dvec2 uv) {
            return triangle.point(uv) + above(uv) * glm::normalize(triangle.linear_normal(uv));
        };
        for (const glm::dvec2 uv : {glm::dvec2(turn * 0.6, 0.9), glm::dvec2(turn * 1.1, 0.8)}) {
            constexpr double step = 1e-5;
            const auto change = [&](const auto& of, glm::dvec2 by) { return (of(uv + by) - of(uv - by)) / (2 * step); };
            const glm::dvec2 u(step, 0);
            const glm::dvec2 v(0, step);
            const glm::dvec3 across = turn * glm::normalize(glm::cross(change(surface, u), change(surface, v)));
            expect_equal(relief_normal(triangle, uv, above(uv), {change(above, u), change(above, v)}), across, 1e-9);
            const auto normal = [&](glm::dvec2 at) { return glm::normalize(triangle.linear_normal(at)); };
            const auto derivatives = normal_derivatives(triangle, uv);
            expect_equal(derivatives[0], change(normal, u), 1e-9);
            expect_equal(derivatives[1], change(normal, v), 1e-9);
            const TangentFrame frame = tangent_frame(triangle, uv);
            expect_equal(frame.along_u, triangle.along_u, 0);
            expect_equal(frame.normal, normal(uv), 1e-15);
        }
    }
}

TEST(MeshView, TheWindowOfParallelRaysHoldsBaseAndFloor) {
    constexpr double height_scale = 0.1;
    for (const Kind kind : {Kind::cylinder, Kind::sphere, Kind::saddle}) {
        for (const double curvature : {-2.0, 1.0, 4.0}) {
            const BaseMesh mesh = generate_base({.kind = kind, .curvature = curvature, .segments = 6});
            const Camera camera{.projection = Projection::parallel, .view_angle = 60, .azimuth = -50};
            const ParallelWindow window = parallel_window(mesh, camera, height_scale);
            const PixelRays rays(camera, {10, 10}, window);
            for (std::size_t index = 0; index < mesh.triangles.size(); ++index) {
                const BaseTriangle triangle = base_triangle(mesh, index);
                const auto& corners = mesh.triangles[index];
                glm::dvec2 middle(0.0);
                for (const std::uint32_t corner : corners)
                    middle += glm::dvec2(mesh.vertices[corner].uv) / 3.0;
                for (const double above : {0.0, -height_scale}) {
                    const glm::dvec3 point =
                        triangle.point(middle) + above * glm::normalize(triangle.linear_normal(middle));
                    const auto pixel = rays.project(point);
                    ASSERT_TRUE(pixel.has_value());
                    ASSERT_GE(std::min(pixel->x, pixel->y), -0.5);
                    ASSERT_LE(std::max(pixel->x, pixel->y), 9.5);
                    ASSERT_LE(point.z, window.top);
                    ASSERT_GE(point.z, window.top - window.depth);
                }
            }
        }
    }
}

TEST(MeshView, NothingIsNearerThanTheNearestDepth) {
    constexpr double height_scale = 0.1;
    const BaseMesh mesh = generate_base({.kind = Kind::sphere, .curvature = -2, .segments = 6});
    const Camera camera{.view_angle = 70, .azimuth = 20};
    const CameraFrame frame = camera_frame(camera);
    const double nearest = nearest_depth(mesh, camera, height_scale);
    EXPECT_GT(nearest, 0.5);
    for (const MeshVertex& vertex : mesh.vertices) {
        for (const double above : {0.0, -height_scale}) {
            const glm::dvec3 point = glm::dvec3(vertex.position) + above * glm::dvec3(vertex.normal);
            EXPECT_GE(glm::dot(point - frame.eye, frame.forward), nearest);
        }
    }
}

TEST(GeneratedBase, RefusesWhatWouldOverlapOrFold) {
    EXPECT_TRUE(curvature_problem({.kind = Kind::cylinder, .curvature = 2 * std::numbers::pi}).empty());
    EXPECT_FALSE(curvature_problem({.kind = Kind::cylinder, .curvature = -6.3}).empty());
    EXPECT_FALSE(curvature_problem({.kind = Kind::sphere, .curvature = 4.5}).empty());
    EXPECT_TRUE(curvature_problem({.kind = Kind::saddle, .curvature = 40}).empty());
    EXPECT_FALSE(curvature_problem({.kind = Kind::saddle, .curvature = std::nan("")}).empty());
    EXPECT_TRUE(folding_problem({.kind = Kind::sphere, .curvature = -4}, 0.5).empty());
    EXPECT_FALSE(folding_problem({.kind = Kind::sphere, .curvature = 4}, 0.25).empty());
    EXPECT_FALSE(folding_problem({.kind = Kind::saddle, .curvature = -4}, 0.25).empty());
    EXPECT_TRUE(folding_problem({.kind = Kind::saddle, .curvature = -4}, 0.24).empty());
}

}  // namespace
}  // namespace reliefbench
