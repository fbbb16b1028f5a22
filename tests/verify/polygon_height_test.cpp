// Relief above and beneath its polygon, against the truth, and the truth against a march of its own.

#include "verify_test.hpp"

#include "reference/truth.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace reliefbench::test {

namespace {

class PolygonHeight : public VerifyTest {
protected:
    static View view_at(double polygon_height, Projection projection, Boundary boundary) {
        View view = projection == Projection::parallel ? parallel_view(60, -67) : perspective_view(60, -67);
        view.relief.height_scale = 0.1;
        view.relief.boundary = boundary;
        set_polygon_height(view, polygon_height);
        return view;
    }
};

}  // namespace

TEST_F(PolygonHeight, ExactTechniquesAgreeWithTheTruth) {
    const CoordinateScene rock(device(), procedural("rock", {64, 64}));
    for (const double height : {0.5, 0.0}) {
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
                const View view = view_at(height, projection, boundary);
                const TruthComparison found = compare("qdm", {{"leaf", std::string("exact")}}, rock, view);
                // Samplers weigh texels in steps.
                EXPECT_LT(found.errors.uv_texels->p99, 0.02) << height << to_string(projection) << to_string(boundary);
                EXPECT_LT(found.errors.missed + found.errors.false_hits, 0.002)
                    << height << to_string(projection) << to_string(boundary);
                EXPECT_GT(found.errors.compared, 1000U);
            }
        }
    }
}

TEST_F(PolygonHeight, TessellationDrawsTheSameSurface) {
    const CoordinateScene rock(device(), procedural("rock", {64, 64}));
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
            const TruthComparison found = compare("tessellation", {}, rock, view_at(0.5, projection, boundary));
            EXPECT_LT(found.errors.uv_texels->p50, 0.05) << to_string(projection) << to_string(boundary);
            EXPECT_LT(found.errors.missed, 0.01) << to_string(projection) << to_string(boundary);
        }
    }
}

/// They begin at the side, too, where searches from the top see nothing.
TEST_F(PolygonHeight, ShellsDrawTheSameSurface) {
    const CoordinateScene rock(device(), procedural("rock", {64, 64}));
    for (const double height : {0.5, 0.0}) {
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            const TruthComparison found = compare("shell_march", {}, rock, view_at(height, projection, Boundary::clip));
            EXPECT_LT(found.errors.uv_texels->p50, 0.05) << height << to_string(projection);
            EXPECT_LT(found.errors.missed, 0.01) << height << to_string(projection);
            EXPECT_GT(found.errors.outside_quad_covered.value(), 0.95) << height << to_string(projection);
        }
    }
}

/// From an eye above the polygon, in steps of a hundredth of a texel.
TEST_F(PolygonHeight, TruthsAreWhatAMarchFinds) {
    const HeightMap map = procedural("waves", {32, 32});
    const View view = view_at(0.3, Projection::perspective, Boundary::repeat);
    const Truth truth = trace_exact_truth(map, load_albedo({}, map), view, Lighting{});
    const double theta = view.camera.view_angle * std::numbers::pi / 180;
    const double phi = view.camera.azimuth * std::numbers::pi / 180;
    const double polygon = -0.7 * 0.1;
    const glm::dvec3 eye = view.camera.distance * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                             std::sin(theta) * std::sin(phi), std::cos(theta)) +
                           glm::dvec3(0, 0, polygon);
    int compared = 0;
    for (int j = 1; j < view.resolution.height; j += 7) {
        for (int i = 1; i < view.resolution.width; i += 5) {
            const Hit& hit = truth.hits.at(i, j);
            if (truth.footprint.at(i, j) != in_footprint || !hit.is_hit()) continue;
            const Ray ray = pixel_ray(view, i, j);
            ASSERT_LT(glm::length(ray.origin - eye), 1e-12);
            const double step = 0.01 / 32;
            double t = -ray.origin.z / ray.direction.z;
            const auto gap = [&](double at) {
                const glm::dvec3 point = ray.origin + at * ray.direction;
                return point.z - (map.sample(point.x + 0.5, point.y + 0.5) - 1) * 0.1;
            };
            while (gap(t) > 0)
                t += step;
            ASSERT_NEAR(hit.t, t, step + 1e-6) << i << ' ' << j;
            ++compared;
        }
    }
    EXPECT_GT(compared, 50);
}

}  // namespace reliefbench::test
