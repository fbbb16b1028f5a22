#include "verify_test.hpp"

#include "core/random.hpp"
#include "metrics/error_maps.hpp"
#include "scene/procedural.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench::test {

namespace {

class Qdm : public VerifyTest {
protected:
    static std::uint32_t unconverged(const Probe& probe) {
        std::uint32_t count = 0;
        for (const PixelWork& work : probe.work.texels)
            count += work.unconverged;
        return count;
    }

    static double steps(const Probe& probe) {
        double sum = 0;
        for (const PixelWork& work : probe.work.texels)
            sum += work.steps;
        return sum;
    }

    static std::uint32_t most_steps(const Probe& probe) {
        std::uint32_t most = 0;
        for (const PixelWork& work : probe.work.texels)
            most = std::max(most, work.steps);
        return most;
    }

    static void expect_first_hits(const CoordinateScene& scene, const View& view, const std::string& what) {
        const TruthComparison found = compare("qdm", {{"leaf", "exact"}}, scene, view);
        ASSERT_TRUE(found.errors.uv_texels) << what;
        EXPECT_LT(found.errors.uv_texels->p99, 0.01) << what;
        EXPECT_LT(found.errors.missed + found.errors.false_hits, 0.005) << what;
        EXPECT_EQ(unconverged(found.probe), 0U) << what;
    }
};

}  // namespace

/// The bound asked for is a tenth of a texel; unfiltered taps do ten times better on every device.
TEST_F(Qdm, ExactLeafFindsTheFirstHitOnEveryMap) {
    for (const ProceduralMap& map : procedural_maps()) {
        const CoordinateScene scene(device(), procedural(map.name, {256, 256}));
        for (const double angle : {0.0, 45.0, 75.0, 85.0})
            expect_first_hits(scene, parallel_view(angle, -70), map.name + " at " + std::to_string(angle));
    }
}

TEST_F(Qdm, AnySizeTilingAndDirection) {
    Random random(3);
    for (const Resolution size :
         {Resolution{1, 1}, Resolution{2, 3}, Resolution{37, 100}, Resolution{129, 8}, Resolution{64, 64}}) {
        const CoordinateScene scene(device(), map_of(size, [&](int, int) { return random.uniform(); }));
        // Along the texels' rows and columns, both ways, and across.
        for (const double azimuth : {-90.0, 0.0, 90.0, 180.0, 33.0}) {
            View view = parallel_view(80, azimuth);
            view.relief.tiling = 2.5;
            view.relief.boundary = Boundary::repeat;
            expect_first_hits(scene, view, fmt::format("{}×{} at azimuth {}", size.width, size.height, azimuth));
        }
    }
}

TEST_F(Qdm, LinearLeafIsWithinHalfATexelInTheMedian) {
    for (const ProceduralMap& map : procedural_maps()) {
        const CoordinateScene scene(device(), procedural(map.name, {128, 128}));
        for (const double angle : {0.0, 45.0, 75.0, 85.0}) {
            const TruthComparison found = compare("qdm", {{"leaf", "linear"}}, scene, parallel_view(angle, -70));
            ASSERT_TRUE(found.errors.uv_texels);
            EXPECT_LT(found.errors.uv_texels->p50, 0.5) << map.name << " at " << angle;
            EXPECT_LT(found.errors.missed + found.errors.false_hits, 0.005) << map.name << " at " << angle;
        }
    }
}

/// A feature is what the truth shows in one connected piece of the picture that rises above the ground; it is missed
/// when no pixel of it is hit within two texels.
TEST_F(Qdm, LinearLeafMissesNoThinFeature) {
    const CoordinateScene scene(device(), procedural("spikes", {128, 128}));
    View view = parallel_view(60, -70);
    view.resolution = {256, 256};
    const TruthComparison found = compare("qdm", {{"leaf", "linear"}}, scene, view);
    const Image<float> errors = uv_error_map(compared_hits(found, scene.map, view.relief));
    constexpr float ground = 0.35F;
    constexpr float same_place_texels = 2;

    Image<std::uint8_t> seen(view.resolution);
    const auto is_feature = [&](int x, int y) {
        const Hit& hit = found.truth.hits.at(x, y);
        return hit.is_hit() && hit.h > ground;
    };
    std::size_t features = 0;
    std::size_t missed = 0;
    for (int y = 0; y < view.resolution.height; ++y) {
        for (int x = 0; x < view.resolution.width; ++x) {
            if (seen.at(x, y) != 0 || !is_feature(x, y)) continue;
            ++features;
            bool hit = false;
            std::vector<std::pair<int, int>> open{{x, y}};
            seen.at(x, y) = 1;
            while (!open.empty()) {
                const auto [cx, cy] = open.back();
                open.pop_back();
                const float error = errors.at(cx, cy);
                hit = hit || (error >= 0 && error < same_place_texels);
                for (const auto& [nx, ny] : {std::pair{cx - 1, cy}, {cx + 1, cy}, {cx, cy - 1}, {cx, cy + 1}}) {
                    if (nx < 0 || ny < 0 || nx >= view.resolution.width || ny >= view.resolution.height) continue;
                    if (seen.at(nx, ny) != 0 || !is_feature(nx, ny)) continue;
                    seen.at(nx, ny) = 1;
                    open.emplace_back(nx, ny);
                }
            }
            if (!hit) ++missed;
        }
    }
    EXPECT_GT(features, 20U);
    EXPECT_EQ(missed, 0U) << "of " << features;
}

/// A search ended by its cap says so, and its pixels stay covered.
TEST_F(Qdm, ACapIsReported) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    const TruthComparison found = compare("qdm", {{"max_steps", std::int64_t{8}}}, scene, parallel_view(75));
    EXPECT_GT(unconverged(found.probe), 100U);
    for (const PixelWork& work : found.probe.work.texels)
        EXPECT_LE(work.steps, 8U);
}

/// h rises and falls evenly between every fourth texel, so that the patches between those are the surface itself.
TEST_F(Qdm, OnACoarseLevelTheExactLeafIsTheSurfaceOfThatLevelsCorners) {
    constexpr int spacing = 4;
    constexpr double steps_per_corner = 65535.0 / 256;  // what r16 stores exactly, between corners too
    const Resolution size{48, 20};
    const auto corner = [](int x, int y) { return (x * 7 + y * 11) % 13 * 16; };
    const auto height = [&](int x, int y) {
        const int x0 = x / spacing;
        const int y0 = y / spacing;
        const int fx = x % spacing;
        const int fy = y % spacing;
        const int x1 = (x0 + 1) % (size.width / spacing);
        const int y1 = (y0 + 1) % (size.height / spacing);
        const int sum = (spacing - fy) * ((spacing - fx) * corner(x0, y0) + fx * corner(x1, y0)) +
                        fy * ((spacing - fx) * corner(x0, y1) + fx * corner(x1, y1));
        return sum / (spacing * spacing) * steps_per_corner / 65535;
    };
    const CoordinateScene scene(device(), map_of(size, height));
    for (View view : {parallel_view(75, -70), perspective_view(60, 25)}) {
        view.relief.tiling = 3;
        const TruthComparison fine = compare("qdm", {}, scene, view);
        const TruthComparison coarse = compare("qdm", {{"finest_level", std::int64_t{2}}}, scene, view);
        ASSERT_TRUE(coarse.errors.uv_texels);
        EXPECT_LT(coarse.errors.uv_texels->p99, 0.01);
        EXPECT_LE(coarse.errors.missed + coarse.errors.false_hits, 0.001);
        EXPECT_LT(steps(coarse.probe), 0.8 * steps(fine.probe));
    }
}

/// 128 texels, three and a half times over 96 pixels: between four and five texels a pixel, both ways.
TEST_F(Qdm, TheLevelByMipIsTheSamplers) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    View view = parallel_view(60, -70);
    view.relief.tiling = 3.5;
    const TruthComparison by_mip = compare("qdm", {{"level_by_mip", true}}, scene, view);
    const TruthComparison fixed = compare("qdm", {{"finest_level", std::int64_t{2}}}, scene, view);
    EXPECT_EQ(by_mip.probe.hits.texels, fixed.probe.hits.texels);
    // The coarser of the two bounds holds.
    const TruthComparison both =
        compare("qdm", {{"level_by_mip", true}, {"finest_level", std::int64_t{3}}}, scene, view);
    const TruthComparison coarser = compare("qdm", {{"finest_level", std::int64_t{3}}}, scene, view);
    EXPECT_EQ(both.probe.hits.texels, coarser.probe.hits.texels);
    EXPECT_NE(both.probe.hits.texels, fixed.probe.hits.texels);
}

TEST_F(Qdm, TheCapFollowsTheViewAngle) {
    constexpr int at_grazing = 24;
    constexpr int head_on = 4;
    const CoordinateScene scene(device(), procedural("spikes", {128, 128}));
    const ParameterValues adaptive{
        {"adaptive", true}, {"max_steps", std::int64_t{at_grazing}}, {"min_steps", std::int64_t{head_on}}};
    for (const double angle : {0.0, 30.0, 45.0, 60.0, 85.0}) {
        const double n_dot_v = std::cos(angle * std::acos(-1.0) / 180);
        const int cap = static_cast<int>(at_grazing + (head_on - at_grazing) * n_dot_v + 1e-6);
        const Probe probe = compare("qdm", adaptive, scene, parallel_view(angle, -70)).probe;
        const std::uint32_t most = most_steps(probe);
        EXPECT_LE(most, static_cast<std::uint32_t>(cap)) << angle;
        // From some angle on searches do run into it.
        const bool capped = unconverged(probe) > 0;
        EXPECT_EQ(capped, angle > 0) << angle;
        EXPECT_EQ(most == static_cast<std::uint32_t>(cap), capped) << angle;
    }
}

/// A ray that has looked closely at the ridge and passes it has far to go over flat ground.
TEST_F(Qdm, WithoutTheAscentItFindsTheSameInMoreSteps) {
    const CoordinateScene scene(device(), map_of({256, 64}, [](int x, int) { return x == 128 ? 0.95 : 0.0; }));
    const View view = parallel_view(80, 0);
    const TruthComparison ascending = compare("qdm", {}, scene, view);
    const TruthComparison level = compare("qdm", {{"ascend", false}}, scene, view);
    ASSERT_TRUE(level.errors.uv_texels);
    EXPECT_LT(level.errors.uv_texels->p99, 0.01);
    EXPECT_EQ(level.errors.missed + level.errors.false_hits, 0);
    EXPECT_GT(most_steps(level.probe), 3 * most_steps(ascending.probe));
}

/// Without an intersection in the leaf the ray stops on the box of its cell: short of the surface.
TEST_F(Qdm, WithoutALeafItStopsOnTheCellsBox) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    const View view = parallel_view(60, -90);
    const TruthComparison found = compare("qdm", {{"leaf", "none"}}, scene, view);
    ASSERT_TRUE(found.errors.uv_texels);
    EXPECT_LE(found.errors.uv_texels->p50, 1.5);
    EXPECT_GT(found.errors.uv_texels->p50, 0.01);
    EXPECT_LT(found.errors.depth->mean, 0);
}

/// Seen head-on a ray stays in its cell: one tap of its four corners.
TEST_F(Qdm, OneTapHeadOn) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    const TruthComparison found = compare("qdm", {}, scene, parallel_view(0));
    for (const PixelWork& work : found.probe.work.texels) {
        EXPECT_EQ(work.taps, 1U);
        EXPECT_EQ(work.texels, 4U);
    }
}

}  // namespace reliefbench::test
