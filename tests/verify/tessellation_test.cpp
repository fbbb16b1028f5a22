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

/// Everything that decides how patches are cut, at settings under which neighbours get different factors.
std::vector<ParameterValues> ways_to_cut() {
    std::vector<ParameterValues> all;
    for (const std::string domain : {"quads", "triangles"}) {
        for (const std::string spacing : {"equal", "fractional_even", "fractional_odd"}) {
            for (const std::string factor_by : {"distance", "edge_length"}) {
                all.push_back({{"domain", domain},
                               {"spacing", spacing},
                               {"factor_by", factor_by},
                               {"patches", std::int64_t{6}},
                               {"factor", std::int64_t{14}},
                               {"near_distance", 0.3},
                               {"far_distance", 1.2},
                               {"segment_pixels", 4.0}});
            }
        }
    }
    return all;
}

/// From so near that factors differ much, over a relief that goes on past the picture: every ray hits a sheet without
/// holes.
View view_of_seams() {
    View view = perspective_view(55, -70);
    view.camera.distance = 0.8;
    view.relief.height_scale = 0.25;
    view.relief.boundary = Boundary::repeat;
    view.resolution = {192, 192};
    return view;
}

std::size_t holes(const TruthComparison& found) {
    std::size_t count = 0;
    for (std::size_t pixel = 0; pixel < found.truth.footprint.texels.size(); ++pixel)
        count += found.truth.footprint.texels[pixel] != 0 && !found.probe.hits.texels[pixel].is_hit() ? 1 : 0;
    return count;
}

}  // namespace

TEST_F(Tessellation, DepthErrorFallsWithEachDoublingUpToTexelSpacing) {
    for (const std::string name : {"rock", "waves", "cobbles"}) {
        const CoordinateScene scene(device(), procedural(name, {128, 128}));
        for (const View& view : {parallel_view(45, -70), perspective_view(60, -70)}) {
            double before = INFINITY;
            for (const auto& [patches, factor] :
                 {std::pair{1, 8}, std::pair{1, 16}, std::pair{1, 32}, std::pair{2, 32}, std::pair{2, 64}}) {
                const TruthComparison found = compare("tessellation", grid(patches, factor), scene, view);
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
        const TruthComparison found = compare("tessellation", {}, scene, view);
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

View view_of_base(BaseSource::Kind kind, double curvature, int segments) {
    View view = perspective_view(50, -70);
    view.relief.base = load_base({.kind = kind, .curvature = curvature, .segments = segments});
    view.resolution = {96, 96};
    return view;
}

// In depth and in normals, which those of a facet would be far from.
TEST_F(Tessellation, OverACurvedBaseConvergesToTheTruth) {
    const CoordinateScene scene(device(), procedural("waves", {64, 64}));
    for (const BaseSource::Kind kind :
         {BaseSource::Kind::cylinder, BaseSource::Kind::sphere, BaseSource::Kind::saddle}) {
        const View view = view_of_base(kind, 1.5, 16);
        const auto errors_at = [&](std::int64_t factor) {
            return compare("tessellation", {{"factor", factor}}, scene, view).errors;
        };
        // One segment for each side of four texels, and one for each texel.
        const HitErrors coarse = errors_at(16);
        const HitErrors fine = errors_at(64);
        EXPECT_LT(fine.depth->p95, coarse.depth->p95 / 4);
        EXPECT_LT(fine.uv_texels->p95, 0.2);
        EXPECT_LT(fine.normal_deg->p95, 1);
        EXPECT_LT(fine.missed + fine.false_hits, 0.01);
        EXPECT_GT(fine.compared, 2000U);
    }
}

/// Misses between hits on both sides.
std::size_t cracks(const Probe& probe) {
    const HitImage& hits = probe.hits;
    std::size_t count = 0;
    for (int j = 1; j + 1 < hits.size.height; ++j) {
        for (int i = 1; i + 1 < hits.size.width; ++i) {
            const auto hit = [&](int x, int y) { return hits.at(i + x, j + y).is_hit(); };
            count += !hit(0, 0) && ((hit(-1, 0) && hit(1, 0)) || (hit(0, -1) && hit(0, 1))) ? 1 : 0;
        }
    }
    return count;
}

/// Large triangles, near enough that factors differ much.
View view_of_curved_seams(BaseSource::Kind kind) {
    View view = view_of_base(kind, 1, 5);
    view.camera.view_angle = 35;
    view.camera.distance = 0.7;
    view.relief.height_scale = 0.1;
    view.resolution = {192, 192};
    return view;
}

TEST_F(Tessellation, SidesOfTrianglesOfACurvedBaseHaveNoHoles) {
    const CoordinateScene scene(device(), procedural("rock", {96, 96}));
    const std::vector<BaseSource::Kind> kinds{BaseSource::Kind::sphere, BaseSource::Kind::saddle};
    for (ParameterValues cut : ways_to_cut()) {
        if (cut.at("domain") == ParameterValue(std::string("quads"))) continue;
        cut.erase("domain");
        cut.erase("patches");
        cut["factor"] = std::int64_t{64};
        for (const BaseSource::Kind kind : kinds)
            EXPECT_EQ(cracks(compare("tessellation", cut, scene, view_of_curved_seams(kind)).probe), 0U);
    }
    const BrokenCopy copy("tessellation", "control.tesc", "0.5 * (vertex_position[a] + vertex_position[b])",
                          "vertex_position[0]");
    const ParameterValues torn =
        with_values(copy.technique().manifest,
                    {{"factor_by", std::string("distance")}, {"near_distance", 0.3}, {"far_distance", 1.2}});
    EXPECT_GT(cracks(compare_with_truth(device(), copy.technique(), torn, scene, view_of_curved_seams(kinds[0])).probe),
              5U);
}

TEST_F(Tessellation, SeamsHaveNoHoles) {
    const CoordinateScene scene(device(), procedural("rock", {32, 32}));
    for (const ParameterValues& cut : ways_to_cut())
        EXPECT_EQ(holes(compare("tessellation", cut, scene, view_of_seams())), 0U)
            << describe(cut, shipped("tessellation").manifest);
}

/// What the test above would see.
TEST_F(Tessellation, FactorsThatNeighboursDoNotShareTearHoles) {
    const CoordinateScene scene(device(), procedural("rock", {32, 32}));
    const BrokenCopy copy("tessellation", "control.tesc", "surface_point(0.5 * (a + b), 1.0)",
                          "surface_point(vertex_corner[0], 1.0)");
    for (const ParameterValues& cut : ways_to_cut()) {
        const ParameterValues values = with_values(copy.technique().manifest, cut);
        EXPECT_GT(holes(compare_with_truth(device(), copy.technique(), values, scene, view_of_seams())), 5U)
            << describe(cut, copy.technique().manifest);
    }
}

/// Beyond the frustum, and behind crests: of waves, and where triangles are not halves of even quads, so that few backs
/// are certain enough to be left out, of a ridge with plain sides.
TEST_F(Tessellation, CullingLeavesPatchesOutAndThePictureAsItIs) {
    struct Case {
        const CoordinateScene* scene;
        View view;
        std::string factor_by;
        std::string domain;
        /// Of the vertices.
        double drawn_at_most;
    };
    constexpr int side = 128;
    const CoordinateScene waves(device(), procedural("waves", {side, side}));
    const CoordinateScene ridge(device(), map_of({side, side}, [](int x, int) {
                                    return 1 - std::abs(x - side / 2) / static_cast<double>(side / 2);
                                }));
    View close = view_of_seams();
    close.camera.distance = 0.35;
    View grazing = parallel_view(84, -70);
    grazing.relief.height_scale = 1;
    View far = perspective_view(82, 20);
    far.relief.height_scale = 0.5;
    const std::vector<Case> cases{
        {&waves, close, "distance", "quads", 0.8},  {&waves, close, "fixed", "triangles", 0.8},
        {&waves, grazing, "fixed", "quads", 0.8},   {&waves, far, "fixed", "quads", 0.9},
        {&ridge, far, "fixed", "triangles", 0.8},   {&ridge, far, "edge_length", "triangles", 0.9},
        {&ridge, grazing, "distance", "quads", 0.9}};
    const Technique technique = shipped("tessellation");
    for (const Case& each : cases) {
        const ParameterValues settings{{"patches", std::int64_t{48}},
                                       {"factor", std::int64_t{3}},
                                       {"factor_by", each.factor_by},
                                       {"domain", each.domain}};
        const std::string what = describe(settings, technique.manifest) + ", " +
                                 describe({&waves == each.scene ? "waves" : "ridge", {side, side}, each.view});
        const auto draw = [&](bool cull) {
            ParameterValues values = with_values(technique.manifest, settings);
            values.at("cull") = cull;
            Renderer renderer(device(), technique, values, each.scene->on_device, each.view, coordinate_lighting());
            renderer.prepare();
            return std::pair{renderer.probe(), renderer.pipeline_statistics()};
        };
        const auto [all, all_statistics] = draw(false);
        const auto [culled, culled_statistics] = draw(true);
        EXPECT_EQ(all.hits.texels, culled.hits.texels) << what;
        EXPECT_EQ(all.colour.texels, culled.colour.texels) << what;
        if (all_statistics.empty()) continue;
        const char* const vertices = "tessellation_evaluation_shader_invocations";
        EXPECT_LE(static_cast<double>(culled_statistics.at(vertices)),
                  each.drawn_at_most * static_cast<double>(all_statistics.at(vertices)))
            << what;
    }
}

/// What the test above would see.
TEST_F(Tessellation, CullingByThePolygonAloneChangesThePicture) {
    const CoordinateScene scene(device(), procedural("waves", {64, 64}));
    const BrokenCopy copy("tessellation", "patch_culling.glsl", "surface_point(uv, float(corner >> 2))",
                          "surface_point(uv, 1.0)");
    View view = view_of_seams();
    view.camera.distance = 0.35;
    const ParameterValues settings{{"patches", std::int64_t{24}}, {"factor", std::int64_t{6}}, {"cull", true}};
    const TruthComparison broken =
        compare_with_truth(device(), copy.technique(), with_values(copy.technique().manifest, settings), scene, view);
    EXPECT_NE(broken.probe.hits.texels, compare("tessellation", settings, scene, view).probe.hits.texels);
}

TEST_F(Tessellation, TrianglesAndGrowingSegmentsShowTheSameSurface) {
    const CoordinateScene scene(device(), procedural("rock", {64, 64}));
    const View view = perspective_view(60, -70);
    const auto hits = [&](const std::string& domain, const std::string& spacing, std::int64_t factor) {
        return compare("tessellation",
                       {{"domain", domain}, {"spacing", spacing}, {"factor", factor}, {"patches", std::int64_t{4}}},
                       scene, view);
    };
    const TruthComparison quads = hits("quads", "equal", 16);
    ASSERT_TRUE(quads.errors.uv_texels);
    // An even number of segments of a side are even segments.
    EXPECT_EQ(hits("quads", "fractional_even", 16).probe.hits.texels, quads.probe.hits.texels);
    for (const auto& [domain, spacing] :
         {std::pair{"triangles", "equal"}, {"quads", "fractional_odd"}, {"triangles", "fractional_odd"}}) {
        const TruthComparison found = hits(domain, spacing, 32);
        ASSERT_TRUE(found.errors.uv_texels);
        EXPECT_LT(found.errors.uv_texels->p95, 1.5 * quads.errors.uv_texels->p95) << domain << ' ' << spacing;
        EXPECT_GT(found.errors.coverage_iou, 0.99) << domain << ' ' << spacing;
    }
}

TEST_F(Tessellation, FactorsFollowDistanceAndLengthOnTheScreen) {
    const CoordinateScene scene(device(), procedural("rock", {64, 64}));
    const View view = perspective_view(45, -70);
    const auto vertices = [&](ParameterValues settings) {
        settings.emplace("patches", std::int64_t{4});
        return compare("tessellation", settings, scene, view).probe.stages.taps;
    };
    const auto fixed = [&](std::int64_t factor) { return vertices({{"factor", factor}}); };
    const auto by_distance = [&](double near, double far) {
        return vertices({{"factor_by", std::string("distance")},
                         {"factor", std::int64_t{16}},
                         {"min_factor", std::int64_t{4}},
                         {"near_distance", near},
                         {"far_distance", far}});
    };
    EXPECT_EQ(by_distance(50, 100), fixed(16));
    EXPECT_EQ(by_distance(0.01, 0.02), fixed(4));
    EXPECT_GT(by_distance(1, 2), 1.2 * fixed(4));
    EXPECT_LT(by_distance(1, 2), 0.8 * fixed(16));

    const auto by_length = [&](double pixels) {
        return vertices({{"factor_by", std::string("edge_length")}, {"segment_pixels", pixels}});
    };
    // Two more vertices on each side than segments of it, so that four times as many segments are less than four times
    // as many vertices.
    EXPECT_GT(by_length(1), 2.5 * by_length(2));
    EXPECT_GT(by_length(2), 1.8 * by_length(4));
}

}  // namespace reliefbench::test
