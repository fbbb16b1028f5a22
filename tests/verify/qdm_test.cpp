#include "verify_test.hpp"

#include "core/random.hpp"
#include "scene/procedural.hpp"

#include <fmt/format.h>

#include <algorithm>

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

    static void expect_first_hits(const CoordinateScene& scene, const View& view, const std::string& what) {
        const Comparison found = compare("qdm", {{"leaf", "exact"}}, scene, view);
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
            const Comparison found = compare("qdm", {{"leaf", "linear"}}, scene, parallel_view(angle, -70));
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
    const Comparison found = compare("qdm", {{"leaf", "linear"}}, scene, view);
    const Image<float> errors = uv_error_map(found.probe.hits, found.truth.hits, scene.map, view.relief);
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
    const Comparison found = compare("qdm", {{"max_steps", std::int64_t{8}}}, scene, parallel_view(75));
    EXPECT_GT(unconverged(found.probe), 100U);
    for (const PixelWork& work : found.probe.work.texels)
        EXPECT_LE(work.steps, 8U);
}

/// Seen head-on a ray stays in its cell: one tap of its four corners.
TEST_F(Qdm, OneTapHeadOn) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    const Comparison found = compare("qdm", {}, scene, parallel_view(0));
    for (const PixelWork& work : found.probe.work.texels) {
        EXPECT_EQ(work.taps, 1U);
        EXPECT_EQ(work.texels, 4U);
    }
}

}  // namespace reliefbench::test
