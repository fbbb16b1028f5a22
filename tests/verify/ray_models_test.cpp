// What the ray models leave of the error that curvature makes, against the exact truth over a cylinder.

#include "verify_test.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <map>

namespace reliefbench::test {
namespace {

class RayModels : public VerifyTest {
protected:
    /// Rays across the bend, one column of them.
    static View view_across(double angle, double curvature, Resolution resolution) {
        View view = parallel_view(angle);
        view.relief.height_scale = 0.05;
        view.relief.base = load_base({.kind = BaseSource::Kind::cylinder, .curvature = curvature, .segments = 128});
        view.resolution = resolution;
        return view;
    }

    /// The row whose rays pass nearest to the origin.
    static int row_of_origin(const View& view) {
        const auto distance = [&](int j) {
            const Ray ray = pixel_ray(view, 0, j);
            return std::abs((glm::cross(ray.origin, ray.direction)).x);
        };
        int nearest = 0;
        for (int j = 1; j < view.resolution.height; ++j) {
            if (distance(j) < distance(nearest)) nearest = j;
        }
        return nearest;
    }

    /// Texels, where the ray enters at the origin, to which the view angle belongs: the mean over the few triangles
    /// there.
    static double error_at_origin(const CoordinateScene& scene, const View& view, const std::string& model) {
        const TruthComparison found = compare("max_mip", {{"ray_model", model}}, scene, view);
        const int middle = row_of_origin(view);
        double sum = 0;
        int count = 0;
        for (int j = middle - 4; j <= middle + 4; ++j, ++count) {
            const Hit& hit = found.probe.hits.at(0, j);
            const Hit& truth = found.truth.hits.at(0, j);
            EXPECT_TRUE(hit.is_hit() && truth.is_hit());
            sum += std::hypot(double(hit.u) - double(truth.u), double(hit.v) - double(truth.v)) *
                   double(scene.map.width());
        }
        return sum / count;
    }
};

// A constant height of 0.3. From the geometry of a smooth cylinder: quadric leaves 0.41 to 0.44 at 60 degrees and 0.67
// to 0.69 at 45, quadric_uv at most 0.07; facets add to either.
TEST_F(RayModels, LeaveOfTheStraightErrorWhatTheGeometrySays) {
    const CoordinateScene scene(device(), map_of({8, 8}, [](int, int) { return 0.3; }));
    const std::map<double, double> quadric_leaves{{45, 0.68}, {60, 0.425}};
    for (const auto& [angle, leaves] : quadric_leaves) {
        const View view = view_across(angle, 1, {1, 129});
        const double straight = error_at_origin(scene, view, "straight");
        const double quadric = error_at_origin(scene, view, "quadric") / straight;
        const double quadric_uv = error_at_origin(scene, view, "quadric_uv") / straight;
        EXPECT_NEAR(quadric, leaves, 0.05) << angle;
        EXPECT_LT(quadric_uv, 0.07) << angle;
    }
}

TEST_F(RayModels, OfWhichTheStraightOneErrsInProportionToCurvature) {
    const CoordinateScene scene(device(), map_of({8, 8}, [](int, int) { return 0.3; }));
    const auto error = [&](double curvature) {
        return error_at_origin(scene, view_across(60, curvature, {1, 129}), "straight") / curvature;
    };
    const double slope = error(0.1);
    EXPECT_NEAR(error(0.2) / slope, 1, 0.1);
    EXPECT_NEAR(error(0.4) / slope, 1, 0.2);
}

// Rays that pass the outline hit what is not there, unless they bend: 4.6, 7.9 and 27 times more of them.
TEST_F(RayModels, ThatBendHitFalselyFarLess) {
    const CoordinateScene scene(device(), procedural("rock", {64, 64}));
    for (const auto& [curvature, angle] : {std::pair(2.0, 60.0), std::pair(4.0, 60.0), std::pair(1.0, 80.0)}) {
        const View view = view_across(angle, curvature, {16, 128});
        const auto false_hits = [&](const std::string& model) {
            return compare("max_mip", {{"ray_model", model}}, scene, view).errors.false_hits;
        };
        const double straight = false_hits("straight");
        const double bent = false_hits("quadric_uv");
        EXPECT_GT(straight, 0.01);
        EXPECT_LT(bent, straight / 4) << "curvature " << curvature << ", " << angle << " degrees";
    }
}

}  // namespace
}  // namespace reliefbench::test
