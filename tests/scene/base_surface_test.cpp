#include "scene/surface/base_surface.hpp"
#include "scene/relief.hpp"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <numbers>

namespace reliefbench {
namespace {

constexpr double tolerance = 1e-14;
constexpr double degree = std::numbers::pi / 180;
const Plane plane;

void expect_equal(glm::dvec3 actual, glm::dvec3 expected, double bound = tolerance) {
    EXPECT_NEAR(actual.x, expected.x, bound);
    EXPECT_NEAR(actual.y, expected.y, bound);
    EXPECT_NEAR(actual.z, expected.z, bound);
}

/// Of the view angle and the azimuth of the camera, off the axes.
constexpr double theta = 55 * degree;
constexpr double phi = 37 * degree;
const glm::dvec3 to_eye{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};

TEST(Plane, APointOfItsReliefLiesOverItsPatchCoordinates) {
    expect_equal(base_point(plane, {0.3, 0.85}, -0.04), {-0.2, 0.35, -0.04}, 1e-16);
    const Relief relief{.height_scale = 0.2};
    expect_equal(surface_point(relief, 0.3, 0.85, 0.75), {-0.2, 0.35, -0.05}, 1e-16);
    expect_equal(base_coordinates(Plane{}, {-0.2, 0.35, -0.04}), {0.3, 0.85, -0.04}, 1e-16);
}

TEST(Plane, TangentSpaceIsTheWorldsAxes) {
    const TangentFrame frame = tangent_frame(plane, {0.2, 0.9});
    EXPECT_EQ(frame.along_u, glm::dvec3(1, 0, 0));
    EXPECT_EQ(frame.along_v, glm::dvec3(0, 1, 0));
    EXPECT_EQ(frame.normal, glm::dvec3(0, 0, 1));
    EXPECT_EQ(frame.from_world({0.3, -0.7, -0.2}), glm::dvec3(0.3, -0.7, -0.2)) << "bit for bit";
}

TEST(TangentFrame, TakesDirectionsApartAlongSkewedAxes) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 2));
    const glm::dvec3 along_u = 0.7 * glm::normalize(glm::cross(normal, glm::dvec3(0, 0, 1)));
    const glm::dvec3 along_v = 1.4 * glm::normalize(glm::cross(normal, along_u)) + 0.3 * along_u;
    const TangentFrame frame{along_u, along_v, normal};
    expect_equal(frame.from_world(0.25 * along_u - 1.5 * along_v + 0.125 * normal), {0.25, -1.5, 0.125});
}

TEST(Plane, NormalsAreThoseOfAGraph) {
    // z = 0.4·u − 1.1·v.
    const glm::dvec3 expected = glm::dvec3(-0.4, 1.1, 1) / std::sqrt(0.16 + 1.21 + 1);
    expect_equal(relief_normal(plane, {0.1, 0.6}, {0.4, -1.1}), expected);
    const glm::dvec3 along_u(1, 0, 0.4);
    const glm::dvec3 along_v(0, 1, -1.1);
    expect_equal(relief_normal(plane, {0.1, 0.6}, {0.4, -1.1}), glm::normalize(glm::cross(along_u, along_v)));
}

TEST(Plane, RaysEnterWhereTheyPassTheUnitSquareFromAbove) {
    const glm::dvec3 aimed{0.13, -0.37, 0};
    const auto entry = find_entry(plane, {aimed + 2.5 * to_eye, -to_eye});
    ASSERT_TRUE(entry);
    EXPECT_NEAR(entry->uv.x, 0.63, tolerance);
    EXPECT_NEAR(entry->uv.y, 0.13, tolerance);
    EXPECT_NEAR(entry->t, 2.5, tolerance);
    EXPECT_EQ(entry->frame.normal, glm::dvec3(0, 0, 1));
    EXPECT_FALSE(find_entry(plane, {glm::dvec3(0.5001, 0.2, 0) + 2.5 * to_eye, -to_eye}));
    EXPECT_FALSE(find_entry(plane, {aimed - 2.5 * to_eye, to_eye})) << "from below";
    EXPECT_FALSE(find_entry(plane, {aimed - 0.1 * to_eye, -to_eye})) << "starts beneath";
}

TEST(Plane, APathThroughTheReliefIsTheRay) {
    constexpr double height_scale = 0.15;
    const Ray ray{glm::dvec3(0.13, -0.37, 0) + 2.5 * to_eye, -to_eye};
    const StraightPath path = straight_path(Plane{}, ray, height_scale);
    // It sinks by H over s = 1: H·tanθ across, H/cosθ along.
    EXPECT_NEAR(path.uv_per_s.x, -height_scale * std::tan(theta) * std::cos(phi), tolerance);
    EXPECT_NEAR(path.uv_per_s.y, -height_scale * std::tan(theta) * std::sin(phi), tolerance);
    EXPECT_NEAR(path.t_per_s, height_scale / std::cos(theta), tolerance);
    const Relief relief{.height_scale = height_scale};
    const double s = 0.7;
    const glm::dvec2 uv = path.uv + s * path.uv_per_s;
    expect_equal(surface_point(relief, uv.x, uv.y, 1 - s),
                 ray.origin + (path.t_top + s * path.t_per_s) * ray.direction);
    EXPECT_TRUE(descends(Plane{}, ray));
    EXPECT_FALSE(descends(Plane{}, {ray.origin, to_eye}));
    EXPECT_FALSE(descends(Plane{}, {ray.origin, {1, 0, 0}}));
}

TEST(Plane, LightComesThroughThePointFromThePlaneOn) {
    const glm::dvec3 point{0.1, -0.2, -0.3};
    const auto ray = light_ray(plane, point, to_eye);
    ASSERT_TRUE(ray);
    EXPECT_EQ(ray->direction, -to_eye);
    expect_equal(ray->origin, point + to_eye * (0.3 / std::cos(theta)));
    EXPECT_FALSE(light_ray(plane, point, glm::normalize(glm::dvec3(1, 1, 0))));
    EXPECT_FALSE(light_ray(plane, point, glm::normalize(glm::dvec3(1, 1, -0.01))));
}

TEST(Plane, RaysAreMovedInUInVAndUpwards) {
    const Ray ray{{0.3, 0.1, 0.4}, -to_eye};
    const Ray earlier = started_above(plane, ray, 0.2);
    EXPECT_NEAR(earlier.origin.z, 0.6, tolerance);
    expect_equal(earlier.origin, ray.origin + to_eye * (0.2 / std::cos(theta)));
    const auto before = find_entry(plane, ray);
    const auto after = find_entry(plane, shifted(plane, ray, {0.01, -0.02, 0}));
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(after->uv.x - before->uv.x, 0.01, tolerance);
    EXPECT_NEAR(after->uv.y - before->uv.y, -0.02, tolerance);
    EXPECT_NEAR(shifted(plane, ray, {0, 0, 0.03}).origin.z, 0.43, tolerance);
}

TEST(Plane, TheVisibleRegionReachesToWhereRaysLeaveTheRelief) {
    constexpr double height_scale = 0.12;
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        const Camera camera{.projection = projection, .view_angle = 55, .azimuth = 37, .distance = 1.7};
        const PatchRegion region = visible_region(plane, camera, height_scale);
        PatchRegion expected;
        for (const double u : {0.0, 1.0}) {
            for (const double v : {0.0, 1.0}) {
                const glm::dvec3 corner{u - 0.5, v - 0.5, 0};
                const glm::dvec3 way = projection == Projection::parallel ? -to_eye : corner - 1.7 * to_eye;
                const glm::dvec3 left = corner + way * (height_scale / -way.z);
                expected.low = {std::min(expected.low.x, left.x + 0.5), std::min(expected.low.y, left.y + 0.5)};
                expected.high = {std::max(expected.high.x, left.x + 0.5), std::max(expected.high.y, left.y + 0.5)};
            }
        }
        EXPECT_NEAR(region.low.x, expected.low.x, tolerance);
        EXPECT_NEAR(region.low.y, expected.low.y, tolerance);
        EXPECT_NEAR(region.high.x, expected.high.x, tolerance);
        EXPECT_NEAR(region.high.y, expected.high.y, tolerance);
        EXPECT_LT(region.low.x, -0.05) << "so that there is something to compare";
    }
}

TEST(ParallelWindow, FillsThePictureWhereverItLies) {
    const Camera camera{.projection = Projection::parallel, .view_angle = 55, .azimuth = 37};
    const ParallelWindow window{{-0.7, -0.4}, {0.9, 1.3}};
    const Resolution size{12, 7};
    const PixelRays rays(camera, size, window);
    const glm::dmat4 clip = parallel_clip(camera, window);
    const glm::dvec2 extent = window.high - window.low;
    for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(3, 5), glm::dvec2(11, 6)}) {
        const Ray ray = rays.at(pixel.x, pixel.y);
        expect_equal(ray.origin, {-0.7 + (pixel.x + 0.5) / 12 * extent.x, 1.3 - (pixel.y + 0.5) / 7 * extent.y, 0});
        const glm::dvec3 point = ray.origin + 0.6 * ray.direction;
        const auto seen = rays.project(point);
        ASSERT_TRUE(seen);
        EXPECT_NEAR(seen->x, pixel.x, 1e-12);
        EXPECT_NEAR(seen->y, pixel.y, 1e-12);
        const glm::dvec4 projected = clip * glm::dvec4(point, 1);
        EXPECT_NEAR((projected.x + 1) / 2 * size.width - 0.5, pixel.x, 1e-12);
        EXPECT_NEAR((projected.y + 1) / 2 * size.height - 0.5, pixel.y, 1e-12);
        EXPECT_NEAR(projected.z, -point.z, tolerance);
    }
}

}  // namespace
}  // namespace reliefbench
