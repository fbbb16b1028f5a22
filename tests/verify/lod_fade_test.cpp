#include "verify_test.hpp"

#include <cmath>

namespace reliefbench::test {

namespace {

class LodFade : public VerifyTest {
protected:
    LodFade() : scene_(device(), procedural("rock", {128, 128})) {}

    /// Parallel rays: every pixel asks for the level log2(128 · tiling / 96) of the map.
    static View view_of_level(double level) {
        View view = parallel_view(50, -70);
        view.relief.boundary = Boundary::repeat;
        view.relief.tiling = 96.0 / 128 * std::exp2(level);
        return view;
    }

    static ParameterValues by_mip() { return {{"lod_fade", std::string("mip")}}; }

    CoordinateScene scene_;
};

/// A level of detail is found from the differences of floats.
constexpr double level_tolerance = 1e-4;

}  // namespace

TEST_F(LodFade, BeyondItsEndNothingIsSearchedFor) {
    for (const std::string technique : {"pom", "parallax", "qdm"}) {
        const TruthComparison found = compare(technique, by_mip(), scene_, view_of_level(3.01));
        for (const Hit& hit : found.probe.hits.texels)
            ASSERT_EQ(hit.h, 1) << technique;
        for (const PixelWork& work : found.probe.work.texels)
            ASSERT_EQ(work.taps + work.steps, 0U) << technique;
        EXPECT_GT(found.errors.uv_texels->p50, 1) << technique << ": the truth stays the relief";
    }
}

TEST_F(LodFade, BeforeItsBeginningItChangesNothing) {
    for (const std::string technique : {"pom", "parallax", "qdm"}) {
        const TruthComparison off = compare(technique, {}, scene_, view_of_level(1.99));
        const TruthComparison on = compare(technique, by_mip(), scene_, view_of_level(1.99));
        EXPECT_EQ(on.probe.hits.texels, off.probe.hits.texels) << technique;
        EXPECT_EQ(on.probe.colour.texels, off.probe.colour.texels) << technique;
    }
}

/// Tatarchuk's sample in the DirectX SDK: the texture coordinates are interpolated by the level's fraction.
TEST_F(LodFade, BetweenThemCoordinatesAreInterpolatedTowardsTheEntry) {
    constexpr double fade = 0.25;
    const View view = view_of_level(2 + fade);
    for (const std::string technique : {"pom", "parallax", "qdm"}) {
        const TruthComparison off = compare(technique, {}, scene_, view);
        const TruthComparison on = compare(technique, by_mip(), scene_, view);
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const Hit& relief = off.probe.hits.at(i, j);
                const Hit& faded = on.probe.hits.at(i, j);
                const glm::dvec2 entry = *footprint_entry(pixel_ray(view, i, j));
                ASSERT_NEAR(faded.u, std::lerp(relief.u, entry.x, fade), level_tolerance) << technique;
                ASSERT_NEAR(faded.v, std::lerp(relief.v, entry.y, fade), level_tolerance) << technique;
                ASSERT_NEAR(faded.h, std::lerp(relief.h, 1.0, fade), level_tolerance) << technique;
            }
        }
    }
}

TEST_F(LodFade, ByDistanceItFollowsTheEye) {
    View view = perspective_view(60);
    view.relief.boundary = Boundary::repeat;
    const TruthComparison off = compare("pom", {}, scene_, view);
    const TruthComparison on = compare(
        "pom", {{"lod_fade", std::string("distance")}, {"lod_fade_end", 1.6}, {"lod_fade_width", 0.2}}, scene_, view);
    int near = 0;
    int far = 0;
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            const Ray ray = pixel_ray(view, i, j);
            const Hit& hit = on.probe.hits.at(i, j);
            if (!hit.is_hit()) continue;
            const double distance = -ray.origin.z / ray.direction.z;
            if (distance < 1.4) {
                ++near;
                ASSERT_EQ(hit, off.probe.hits.at(i, j));
            } else if (distance > 1.6) {
                ++far;
                ASSERT_EQ(on.probe.work.at(i, j).taps, 0U);
                ASSERT_EQ(hit.h, 1);
            }
        }
    }
    EXPECT_GT(near, 100);
    EXPECT_GT(far, 100);
}

TEST_F(LodFade, ItsCostFallsAndItsErrorRisesAsItComesNearer) {
    View view = perspective_view(60);
    view.relief.boundary = Boundary::repeat;
    double taps = INFINITY;
    double error = 0;
    for (const double end : {3.0, 1.7, 1.4, 1.0}) {
        const TruthComparison found =
            compare("pom", {{"lod_fade", std::string("distance")}, {"lod_fade_end", end}, {"lod_fade_width", 0.2}},
                    scene_, view);
        double sum = 0;
        for (const PixelWork& work : found.probe.work.texels)
            sum += work.taps;
        EXPECT_LT(sum, taps) << end;
        EXPECT_GT(found.errors.uv_texels->mean, error) << end;
        taps = sum;
        error = found.errors.uv_texels->mean;
    }
    EXPECT_EQ(taps, 0);
}

}  // namespace reliefbench::test
