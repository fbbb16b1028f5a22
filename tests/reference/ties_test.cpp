#include "reference/ties.hpp"

#include "reference/mesh_tracer.hpp"
#include "reference/truth.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <functional>
#include <optional>

namespace reliefbench {
namespace {

HeightMap map_of(Resolution size, const std::function<double(int x, int y)>& height) {
    Image<float> heights(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            heights.at(x, y) = static_cast<float>(height(x, y));
    }
    return make_height_map(heights, HeightFormat::r32f, "made");
}

/// Flat-topped tiles with joints two texels wide.
HeightMap tiles(int side) {
    return map_of({side, side}, [](int x, int y) { return x % 8 < 6 && y % 8 < 6 ? 1.0 : 0.2; });
}

View parallel_view(double angle, double azimuth, int side, Boundary boundary = Boundary::clip) {
    View view;
    view.camera = {Projection::parallel, angle, azimuth};
    view.relief.height_scale = 0.1;
    view.relief.boundary = boundary;
    view.resolution = {side, side};
    return view;
}

Truth truth_of(const HeightMap& map, const View& view) {
    return trace_exact_truth(map, load_albedo({}, map), view, Lighting{});
}

double fraction_of_ties(const Truth& truth) {
    double ties = 0;
    for (const std::uint8_t pixel : truth.footprint.texels)
        ties += pixel == tie_in_footprint ? 1 : 0;
    return ties / static_cast<double>(truth.footprint.texels.size());
}

/// Parallel rays at 45° towards greater u over one step from h = 1 down to h = 0, between the texels 7 and 8 of 16.
class EdgeOfAPlateau : public testing::Test {
protected:
    const HeightMap map_ = map_of({16, 16}, [](int x, int) { return x < 8 ? 1.0 : 0.0; });
    const Relief relief_{.height_scale = 0.25};
    const double edge_ = 7.5 / 16;

    static Ray ray_at(double u) { return {{u - 0.5, 0.03, 0}, {std::sqrt(0.5), 0, -std::sqrt(0.5)}}; }
};

TEST_F(EdgeOfAPlateau, ARayThatEntersThereHasHit) {
    const ExactTracer exact(map_, relief_);
    View view;
    view.relief = relief_;
    const MeshTracer mesh(map_, view, 2);
    for (const double u : {edge_, edge_ - 0.01, edge_ + 1e-9}) {
        for (const auto& hit : {exact.trace(ray_at(u)), mesh.trace(ray_at(u))}) {
            ASSERT_TRUE(hit) << u;
            EXPECT_NEAR(hit->u, u, 1e-12);
            EXPECT_EQ(hit->t, 0);
        }
    }
    // A thousandth of a texel farther the ray passes the edge, whose wall is steeper than it, and comes to the ground.
    const auto beyond = exact.trace(ray_at(edge_ + 0.001 / 16));
    ASSERT_TRUE(beyond);
    EXPECT_NEAR(beyond->h, 0, 1e-12);
}

TEST_F(EdgeOfAPlateau, IsATieAndNothingElseIs) {
    const ExactTracer tracer(map_, relief_);
    const TieFinder ties(map_, relief_, tracer);
    const auto is_tie = [&](double texels_from_edge) { return ties.is_tie(ray_at(edge_ + texels_from_edge / 16)); };
    EXPECT_TRUE(is_tie(0));
    EXPECT_TRUE(is_tie(0.9e-4));
    EXPECT_TRUE(is_tie(-0.9e-4));
    EXPECT_FALSE(is_tie(1.2e-4));
    EXPECT_FALSE(is_tie(-1.2e-4));
    EXPECT_FALSE(is_tie(-3));
    EXPECT_FALSE(is_tie(3));
}

TEST(Ties, ARidgeThatTheRayGrazesIsOne) {
    // A ridge of height 1/2 along v, reached halfway down by a ray at 45° from texel 4 on.
    const HeightMap map = map_of({16, 16}, [](int x, int) { return x == 8 ? 0.5 : 0.0; });
    const Relief relief{.height_scale = 0.5};
    const ExactTracer tracer(map, relief);
    const TieFinder ties(map, relief, tracer);
    const double to_ridge = 8.5 / 16 - 0.25;
    for (const auto& [offset, tie] :
         {std::pair{0.0, true}, {0.5e-4, true}, {-0.5e-4, true}, {1e-3, false}, {-1e-3, false}}) {
        const Ray ray{{to_ridge + offset / 16 - 0.5, 0.03, 0}, {std::sqrt(0.5), 0, -std::sqrt(0.5)}};
        EXPECT_EQ(ties.is_tie(ray), tie) << offset;
    }
}

TEST(Ties, SmoothReliefHasNone) {
    const HeightMap map =
        map_of({32, 32}, [](int x, int y) { return 0.5 + 0.2 * std::sin(0.4 * x) * std::cos(0.4 * y); });
    EXPECT_EQ(fraction_of_ties(truth_of(map, parallel_view(50, -67, 32))), 0);
    const HeightMap plane = map_of({8, 8}, [](int, int) { return 1.0; });
    EXPECT_EQ(fraction_of_ties(truth_of(plane, parallel_view(80, -90, 32))), 0);
}

/// Whether a dense march finds the ray beneath the surface, counting as beneath what is so by more than `least`.
std::optional<double> first_beneath(const HeightMap& map, const View& view, const Ray& ray, double least) {
    constexpr int steps = 4000;
    const double per_s = view.relief.height_scale / -ray.direction.z;
    const double u = ray.origin.x + 0.5;
    const double v = ray.origin.y + 0.5;
    for (int step = 0; step <= steps; ++step) {
        const double s = static_cast<double>(step) / steps;
        const double x = u + s * per_s * ray.direction.x;
        const double y = v + s * per_s * ray.direction.y;
        if (view.relief.boundary == Boundary::clip && (x < 0 || x > 1 || y < 0 || y > 1)) return std::nullopt;
        if (map.sample(x, y) - (1 - s) > least) return s;
    }
    return 1;
}

/// Where marches that take a touch for a hit, and for none, come to other points, the truth has marked a tie.
TEST(Ties, AreWhereTouchesDecide) {
    for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
        for (const double azimuth : {-90.0, -75.0, -45.0, 0.0}) {
            const HeightMap map = tiles(32);
            const View view = parallel_view(60, azimuth, 32, boundary);
            const Truth truth = truth_of(map, view);
            const double texels = 32 * view.relief.height_scale * std::tan(glm::radians(60.0));
            int touches = 0;
            for (int j = 0; j < 32; ++j) {
                for (int i = 0; i < 32; ++i) {
                    const Ray ray = pixel_ray(view, i, j);
                    const auto eager = first_beneath(map, view, ray, -1e-9);
                    const auto strict = first_beneath(map, view, ray, 1e-9);
                    const bool differ =
                        eager.has_value() != strict.has_value() || (eager && std::abs(*eager - *strict) * texels > 0.6);
                    touches += differ ? 1 : 0;
                    if (!differ) continue;
                    EXPECT_EQ(truth.footprint.at(i, j), tie_in_footprint) << i << " " << j << " " << azimuth;
                }
            }
            EXPECT_GT(touches, 0) << azimuth;
            // Three of four edges of each tile: along the rays and where they go outwards.
            EXPECT_LT(fraction_of_ties(truth), 0.2);
        }
    }
}

}  // namespace
}  // namespace reliefbench
