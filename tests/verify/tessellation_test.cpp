#include "verify_test.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench::test {

namespace {

class Tessellation : public VerifyTest {
protected:
    /// |h00 + h11 − h01 − h10|/4 of the cell around a texture coordinate: how far two triangles lie from the bilinear
    /// surface at the cell's centre, where they lie farthest.
    static double twist_bound(const HeightMap& map, double u, double v) {
        const auto x = static_cast<std::int64_t>(std::floor(u * map.width() - 0.5));
        const auto y = static_cast<std::int64_t>(std::floor(v * map.height() - 0.5));
        return std::abs(map.texel(x, y) + map.texel(x + 1, y + 1) - map.texel(x, y + 1) - map.texel(x + 1, y)) / 4;
    }
};

ParameterValues grid(std::int64_t patches, std::int64_t factor) {
    return {{"patches", patches}, {"factor", factor}};
}

}  // namespace

TEST_F(Tessellation, DepthErrorFallsWithEachDoublingUpToTexelSpacing) {
    for (const std::string name : {"rock", "waves", "cobbles"}) {
        const CoordinateScene scene(device(), procedural(name, {128, 128}));
        for (const View& view : {parallel_view(45, -70), perspective_view(60, -70)}) {
            double before = INFINITY;
            for (const auto& [patches, factor] :
                 {std::pair{1, 8}, std::pair{1, 16}, std::pair{1, 32}, std::pair{2, 32}, std::pair{2, 64}}) {
                const Comparison found = compare("tessellation", grid(patches, factor), scene, view);
                ASSERT_TRUE(found.errors.depth);
                EXPECT_LT(found.errors.depth->p50, before) << name << " " << patches << "·" << factor;
                before = found.errors.depth->p50;
            }
        }
    }
}

/// At texel spacing vertices lie on texel centres, so that the split into triangles is all that is left. Head-on the
/// depth error is the difference of heights itself; the outermost quads, which end on the border, are left out.
TEST_F(Tessellation, AtTexelSpacingTheErrorIsWithinTheTwistBound) {
    // At 320² there are more vertices than 16 bits number.
    for (const auto& [name, side] : {std::pair{"rock", 128}, {"spikes", 128}, {"steps", 128}, {"rock", 320}}) {
        const CoordinateScene scene(device(), procedural(name, {side, side}));
        const View view = parallel_view(0);
        const Comparison found = compare("tessellation", {}, scene, view);
        // Vertices snap to 1/256 pixel, which moves a slope of the full height per texel by as many texels.
        const double snapping = static_cast<double>(side) / view.resolution.width / 256;
        std::size_t compared = 0;
        for (const Hit& hit : found.truth.hits.texels) {
            const auto pixel = static_cast<std::size_t>(&hit - found.truth.hits.texels.data());
            const double border = 2.0 / side;
            if (std::min({hit.u, hit.v, 1 - hit.u, 1 - hit.v}) < border) continue;
            ++compared;
            const double error = std::abs(found.probe.hits.texels[pixel].h - hit.h);
            ASSERT_LE(error, twist_bound(scene.map, hit.u, hit.v) + snapping)
                << name << " at " << hit.u << ", " << hit.v;
        }
        EXPECT_GT(compared, 8000U);
    }
}

TEST_F(Tessellation, DefaultsAreOneQuadPerTexel) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    const Technique technique = shipped("tessellation");
    const View view = parallel_view(30);
    Renderer renderer(device(), technique, technique.manifest.defaults(), scene.on_device, view, coordinate_lighting());
    renderer.prepare();
    const PipelineStatistics statistics = renderer.pipeline_statistics();
    if (statistics.empty()) GTEST_SKIP() << "the device has no pipeline statistics";
    EXPECT_EQ(statistics.at("tessellation_control_shader_patches"), 4U);
    EXPECT_EQ(renderer.probe().stages.taps, statistics.at("tessellation_evaluation_shader_invocations"));
    EXPECT_GE(renderer.probe().stages.taps, 4U * 65 * 65);
}

/// Real geometry shows past the polygon's outline, where no per-pixel technique can draw.
TEST_F(Tessellation, CoversTheReliefOutsideTheQuad) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    View view = perspective_view(80);
    view.resolution = {192, 192};
    const HitErrors errors = compare("tessellation", {}, scene, view).errors;
    EXPECT_GT(errors.outside_quad_pixels, 500U);
    EXPECT_GT(errors.outside_quad_covered.value_or(0), 0.98);
    EXPECT_GT(errors.coverage_iou, 0.98);
    for (const std::string technique : {"flat", "parallax", "steep", "relief", "pom", "qdm"}) {
        EXPECT_EQ(compare(technique, {}, scene, view).errors.outside_quad_covered.value_or(1), 0) << technique;
    }
}

}  // namespace reliefbench::test
