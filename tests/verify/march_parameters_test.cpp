#include "verify_test.hpp"

#include "metrics/error_maps.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbench::test {

namespace {

/// The shared parameters of the marching family (harness/shaders/library/march.json).
class MarchParameters : public VerifyTest {
protected:
    static View repeating(View view) {
        view.relief.boundary = Boundary::repeat;
        return view;
    }

    /// Steps of a pixel over a map of h = 0, on which every ray takes all of its steps.
    std::uint32_t steps_through(const View& view, const ParameterValues& changed) {
        const CoordinateScene floor(device(), map_of({16, 16}, [](int, int) { return 0.0; }));
        return compare("steep", changed, floor, repeating(view)).probe.work.at(40, 40).steps;
    }
};

ParameterValues with(ParameterValues values, const ParameterValues& more) {
    for (const auto& [name, value] : more)
        values[name] = value;
    return values;
}

const ParameterValues ten_to_fifty_one{
    {"min_steps", std::int64_t{10}}, {"max_steps", std::int64_t{51}}, {"step_rounding", std::string("integer")}};

/// The largest difference of two vertical neighbours' errors, in texels: a band's edge.
double largest_jump(const Image<float>& errors) {
    double largest = 0;
    for (int j = 1; j < errors.size.height; ++j) {
        for (int i = 0; i < errors.size.width; ++i) {
            const double jump = std::abs(errors.at(i, j) - errors.at(i, j - 1));
            // Not a number where a pixel has no hit.
            if (jump > largest) largest = jump;
        }
    }
    return largest;
}

}  // namespace

TEST_F(MarchParameters, EveryRefinementIsOneOfEveryMarch) {
    const CoordinateScene rock(device(), procedural("rock", {96, 64}));
    const View view = perspective_view(60, -70);
    for (const auto& [technique, refinement] :
         {std::pair{"relief", "binary"}, {"pom", "linear"}, {"secant", "secant"}, {"contact_refinement", "contact"}}) {
        const Manifest manifest = shipped(technique).manifest;
        EXPECT_EQ(manifest.defaults().at("refinement"), ParameterValue(std::string(refinement)));
        ParameterValues values = manifest.defaults();
        const TruthComparison own = compare(technique, {}, rock, view);
        const TruthComparison through_steep = compare("steep", values, rock, view);
        EXPECT_EQ(own.probe.hits.texels, through_steep.probe.hits.texels) << technique;
        values["refinement"] = std::string("none");
        EXPECT_NE(own.probe.hits.texels, compare(technique, values, rock, view).probe.hits.texels) << technique;
    }
}

/// Two finer steps in place of one are a halving, and their answer is the first beneath.
TEST_F(MarchParameters, ContactRefinementByTwoIsTheBinarySearch) {
    const CoordinateScene rock(device(), procedural("rock", {96, 64}));
    const View view = perspective_view(60, -70);
    const ParameterValues twos{
        {"refinement_steps", std::int64_t{2}}, {"refinements", std::int64_t{6}}, {"min_steps", std::int64_t{10}}};
    EXPECT_EQ(compare("contact_refinement", twos, rock, view).probe.hits.texels,
              compare("relief", {{"binary_answer", std::string("beneath")}}, rock, view).probe.hits.texels);
}

/// The same taps, half the error: on a smooth map, where every ray finds its layer.
TEST_F(MarchParameters, TheMiddleOfTheLastIntervalHalvesTheError) {
    const CoordinateScene waves(device(), procedural("waves", {256, 256}));
    View view = repeating(parallel_view(60, -67));
    view.relief.height_scale = 0.02;
    const auto largest = [&](const std::string& answer) {
        return compare("relief", {{"binary_steps", std::int64_t{2}}, {"binary_answer", answer}}, waves, view)
            .errors.uv_texels->max;
    };
    EXPECT_NEAR(largest("middle"), 0.5 * largest("beneath"), 0.02 * largest("beneath"));
    EXPECT_NEAR(largest("middle"), 0.5 * largest("above"), 0.02 * largest("beneath"));
}

TEST_F(MarchParameters, LayersFollowTheAngle) {
    for (const double angle : {0.0, 20.0, 45.0, 60.0, 80.0}) {
        const double layers = std::lerp(10, 51, angle / 90);
        const auto by_angle = with(ten_to_fifty_one, {{"adaptive_by", std::string("angle")}});
        // Single floats decide between neighbours where the count is close to whole.
        EXPECT_NEAR(steps_through(parallel_view(angle), by_angle), layers, 1.001) << angle;
        EXPECT_LE(steps_through(parallel_view(angle), by_angle), layers + 0.001) << angle;
    }
}

TEST_F(MarchParameters, LayersFollowTheTexelsCrossed) {
    for (const double angle : {0.0, 60.0, 80.0, 86.0}) {
        // H·tanθ·N: 0, 2.8, 9.1, 22.9 texels of the 16 on a side.
        const double texels = 0.1 * std::tan(angle * std::numbers::pi / 180) * 16;
        ParameterValues values = with(ten_to_fifty_one, {{"adaptive_by", std::string("texels")}});
        EXPECT_EQ(steps_through(parallel_view(angle), values), std::clamp(std::floor(texels), 10.0, 51.0)) << angle;
        values["layers_per_texel"] = 4.0;
        EXPECT_EQ(steps_through(parallel_view(angle), values), std::clamp(std::floor(4 * texels), 10.0, 51.0)) << angle;
    }
}

/// In a relief of unit depth whose coordinates are the texture's the ray comes down at atan(H·tanθ).
TEST_F(MarchParameters, LayersFollowTheAngleInTextureSpace) {
    for (const double angle : {0.0, 60.0, 80.0, 86.0}) {
        const double angle_in_uv = std::atan(0.1 * std::tan(angle * std::numbers::pi / 180));
        const double layers = std::lerp(10, 51, angle_in_uv / (std::numbers::pi / 2));
        EXPECT_EQ(
            steps_through(parallel_view(angle), with(ten_to_fifty_one, {{"adaptive_by", std::string("uv_angle")}})),
            std::floor(layers))
            << angle;
    }
}

TEST_F(MarchParameters, LayersFallWithTheDistance) {
    const auto values = [](double end) {
        return with(ten_to_fifty_one, {{"adaptive_by", std::string("distance")}, {"steps_end_distance", end}});
    };
    const View view = perspective_view(60, -70);
    const Ray ray = pixel_ray(view, 40, 40);
    const double distance = -ray.origin.z / ray.direction.z;
    for (const double end : {100.0, 4.0, 2.5, 1.0}) {
        EXPECT_EQ(steps_through(view, values(end)), std::max(10.0, std::floor(51 * (1 - distance / end)))) << end;
    }
    EXPECT_EQ(steps_through(parallel_view(60), values(1)), 51U) << "parallel rays come from no distance";
}

/// The base's points lie elsewhere than the plane's. What answers with the polygon tells where.
TEST_F(MarchParameters, LayersFallWithTheDistanceToACurvedBase) {
    View view = repeating(perspective_view(50, -70));
    const CoordinateScene floor(device(), map_of({16, 16}, [](int, int) { return 0.0; }));
    const Probe plane = compare("flat", {}, floor, view).probe;
    view.relief.base = load_base({.kind = BaseSource::Kind::cylinder, .curvature = 1.5, .segments = 64});
    const Probe base = compare("flat", {}, floor, view).probe;
    const double end = 3;
    const ParameterValues values =
        with(ten_to_fifty_one, {{"adaptive_by", std::string("distance")}, {"steps_end_distance", end}});
    const Probe marched = compare("steep", values, floor, view).probe;
    int compared = 0;
    double from_plane = 0;
    for (std::size_t i = 0; i < base.hits.texels.size(); ++i) {
        if (!base.hits.texels[i].is_hit() || !plane.hits.texels[i].is_hit()) continue;
        const double layers = std::max(10.0, 51 * (1 - base.hits.texels[i].t / end));
        // Single floats decide what is cut off there.
        if (std::abs(layers - std::round(layers)) < 1e-3) continue;
        ASSERT_EQ(marched.work.texels[i].steps, std::floor(layers)) << i;
        from_plane = std::max(from_plane, double(std::abs(base.hits.texels[i].t - plane.hits.texels[i].t)));
        ++compared;
    }
    EXPECT_GT(compared, 1000);
    EXPECT_GT(from_plane, 0.05);
    view.camera.projection = Projection::parallel;
    EXPECT_EQ(compare("steep", values, floor, view).probe.work.at(40, 40).steps, 51U);
}

/// Of texels as wide as a pixel the ray crosses the fewer the farther away it is seen.
TEST_F(MarchParameters, LayersFollowTheTexelsOfTheLevelRead) {
    View view = parallel_view(60);
    view.relief.tiling = 24;  // 16·24/96: four texels a pixel, level 2
    const double texels = 0.1 * std::tan(std::numbers::pi / 3) * 16 * 24;
    for (const std::string lod : {"entry", "gradients"}) {
        ParameterValues values = with(ten_to_fifty_one, {{"adaptive_by", std::string("texels")}, {"height_lod", lod}});
        EXPECT_EQ(steps_through(view, values), 51U) << lod;
        values["texels_of"] = std::string("level_read");
        EXPECT_EQ(steps_through(view, values), std::floor(texels / 4)) << lod;
    }
    EXPECT_EQ(steps_through(view, with(ten_to_fifty_one, {{"adaptive_by", std::string("texels")},
                                                          {"height_lod", std::string("entry")},
                                                          {"height_lod_bias", 1.0},
                                                          {"texels_of", std::string("level_read")}})),
              10U)
        << "8.3 texels of level 3";
}

TEST_F(MarchParameters, CountsGoUpToMultiplesOfFour) {
    const auto rounded = with(ten_to_fifty_one, {{"step_rounding", std::string("multiple_of_4")}});
    EXPECT_EQ(steps_through(parallel_view(0), rounded), 12U) << "10";
    EXPECT_EQ(steps_through(parallel_view(60), rounded), 32U) << "30.5";
    const auto even = with(rounded, {{"min_steps", std::int64_t{8}}, {"max_steps", std::int64_t{8}}});
    EXPECT_EQ(steps_through(parallel_view(60), even), 8U);
}

TEST_F(MarchParameters, FractionalCountsEndWithAThinnerLayer) {
    // At 60°, mix(51, 10, 1/2) = 30.5.
    EXPECT_EQ(steps_through(parallel_view(60), ten_to_fifty_one), 30U);
    EXPECT_EQ(steps_through(parallel_view(60), with(ten_to_fifty_one, {{"step_rounding", std::string("fractional")}})),
              31U);
    // Between the last layer but one and the last a chord is exact on a plane, however thin the layer.
    const CoordinateScene low(device(), map_of({16, 16}, [](int, int) { return 0.001; }));
    const TruthComparison found = compare("pom", with(ten_to_fifty_one, {{"step_rounding", std::string("fractional")}}),
                                          low, repeating(parallel_view(60)));
    EXPECT_NEAR(found.probe.hits.at(40, 40).h, 0.001, 2e-5);
}

/// Where a whole count changes from pixel to pixel, all layers move at once.
TEST_F(MarchParameters, FractionalCountsShowNoBands) {
    const CoordinateScene waves(device(), procedural("waves", {256, 256}));
    View view = repeating(perspective_view(45));
    // So finely that within a band neighbours differ little.
    view.camera.fov = 10;
    view.resolution = {8, 4096};
    view.relief.height_scale = 0.1;
    ParameterValues values{{"min_steps", std::int64_t{4}}, {"max_steps", std::int64_t{16}}};
    const auto jump = [&](const std::string& rounding) {
        values["step_rounding"] = rounding;
        const TruthComparison found = compare("pom", values, waves, view);
        return largest_jump(uv_error_map(compared_hits(found, waves.map, view.relief)));
    };
    // What is left is the error's slope within a band.
    EXPECT_LT(jump("fractional"), 0.5 * jump("integer"));
}

/// Stripes that repeat every eight texels have no relief left at the level of pixels eight texels wide: their mean.
TEST_F(MarchParameters, HeightsAreReadAtTheLevelOfTheEntrysFootprint) {
    const CoordinateScene stripes(device(), map_of({64, 64}, [](int x, int) { return x % 8 < 2 ? 1.0 : 0.2; }));
    View view = repeating(parallel_view(60));
    view.relief.tiling = 13;  // 64·13/96: between eight and nine texels a pixel, between levels 3 and 4
    const auto heights = [&](const std::string& lod) {
        std::vector<float> found;
        for (const Hit& hit : compare("pom", {{"height_lod", lod}}, stripes, view).probe.hits.texels)
            found.push_back(hit.h);
        return found;
    };
    constexpr double mean = (2 * 1.0 + 6 * 0.2) / 8;
    for (const std::string lod : {"entry", "gradients"}) {
        for (const float h : heights(lod))
            ASSERT_NEAR(h, mean, 2e-5) << lod;
    }
    const std::vector<float> at_zero = heights("zero");
    const auto [lowest, highest] = std::ranges::minmax(at_zero);
    EXPECT_GT(highest - lowest, 0.5F) << "level 0 keeps the stripes";
}

/// Stripes as above, in pixels one texel wide and sixteen high.
TEST_F(MarchParameters, TheLesserAxisOfTheFootprintReadsTheFinerLevel) {
    const CoordinateScene stripes(device(), map_of({64, 64}, [](int x, int) { return x % 8 < 2 ? 1.0 : 0.2; }));
    View view = repeating(parallel_view(60));
    view.relief.tiling = 3;
    view.resolution = {192, 12};
    const auto heights = [&](const std::string& axis, double bias) {
        std::vector<float> found;
        const ParameterValues values{
            {"height_lod", std::string("entry")}, {"height_lod_axis", axis}, {"height_lod_bias", bias}};
        for (const Hit& hit : compare("pom", values, stripes, view).probe.hits.texels)
            found.push_back(hit.h);
        return found;
    };
    const std::vector<float> lesser = heights("lesser", 0);
    const auto [lowest, highest] = std::ranges::minmax(lesser);
    EXPECT_GT(highest - lowest, 0.5F) << "level 0";
    // Derivatives are of single floats, so that the level is 0 but for their rounding.
    EXPECT_THAT(heights("greater", -4), testing::Pointwise(testing::FloatNear(1e-5F), lesser)) << "log2 16 less";
    for (const auto& mean : {heights("greater", 0), heights("lesser", 4)}) {
        for (const float h : mean)
            ASSERT_NEAR(h, 0.4, 2e-5);
    }
}

/// Between levels, and where the side of the map is no power of two.
TEST_F(MarchParameters, GradientsOfTheEntryAndOneLevelForAllStepsAgree) {
    const CoordinateScene rock(device(), procedural("rock", {100, 60}));
    View view = repeating(parallel_view(60, -70));
    view.relief.tiling = 4;
    const TruthComparison level = compare("pom", {{"height_lod", std::string("entry")}}, rock, view);
    const TruthComparison gradients = compare("pom", {{"height_lod", std::string("gradients")}}, rock, view);
    const TruthComparison zero = compare("pom", {}, rock, view);
    double from_level = 0;
    double from_zero = 0;
    for (std::size_t i = 0; i < level.probe.hits.texels.size(); ++i) {
        const float h = gradients.probe.hits.texels[i].h;
        from_level += std::abs(h - level.probe.hits.texels[i].h);
        from_zero += std::abs(h - zero.probe.hits.texels[i].h);
    }
    // Samplers approximate the logarithm that gives the level.
    EXPECT_LT(from_level, 0.1 * from_zero);
    EXPECT_GT(gradients.probe.work.at(40, 40).taps, 0U);
}

/// Over a curved base and one bent by hand, too, and with layers that are moved.
TEST_F(MarchParameters, FourTapsAtATimeFindTheSameHits) {
    const CoordinateScene rock(device(), procedural("rock", {96, 64}));
    const View view = perspective_view(70, -70);
    const std::vector<std::pair<std::string, ParameterValues>> marches{
        {"steep", {}},
        {"pom", {}},
        {"secant", {{"max_steps", std::int64_t{13}}}},
        {"relief", {{"start_offset", std::string("gradient_noise")}}},
        {"contact_refinement", {{"adaptive", false}}},
        {"pom", {{"hand_curvature", std::string("constant")}, {"curvature_along_u", 3.0}}},
        {"pom", {{"ray_model", std::string("quadric_uv")}}}};
    for (const auto& [technique, values] : marches) {
        View seen = view;
        if (values.contains("ray_model"))
            seen.relief.base = load_base({.kind = BaseSource::Kind::cylinder, .curvature = 1.5, .segments = 64});
        const Probe one = compare(technique, values, rock, seen).probe;
        const Probe four = compare(technique, with(values, {{"tap_batch", std::string("four")}}), rock, seen).probe;
        EXPECT_EQ(four.hits.texels, one.hits.texels) << technique;
        int more = 0;
        for (std::size_t i = 0; i < one.work.texels.size(); ++i) {
            const int vain = int(four.work.texels[i].taps) - int(one.work.texels[i].taps);
            ASSERT_GE(vain, 0) << technique;
            ASSERT_LE(vain, 3) << technique;
            ASSERT_EQ(four.work.texels[i].steps, one.work.texels[i].steps) << technique;
            more += vain > 0 ? 1 : 0;
        }
        EXPECT_GT(more, 100) << technique;
    }
}

TEST_F(MarchParameters, ASecantWithinItsToleranceIsTheAnswer) {
    const CoordinateScene rock(device(), procedural("rock", {96, 64}));
    const View view = repeating(perspective_view(60, -70));
    const ParameterValues twenty{{"adaptive", false}, {"max_steps", std::int64_t{20}}};
    const auto secants = [&](double tolerance) {
        return compare("secant", with(twenty, {{"secant_steps", std::int64_t{40}}, {"secant_tolerance", tolerance}}),
                       rock, view)
            .probe;
    };
    EXPECT_EQ(secants(1).hits.texels, compare("pom", twenty, rock, view).probe.hits.texels)
        << "the first chord, whatever it leaves";
    const Probe ended = secants(0.01);
    for (const Hit& hit : ended.hits.texels) {
        // Sampler and processor differ by the weights' rounding.
        if (!hit.is_hit()) continue;
        ASSERT_NEAR(hit.h, rock.map.sample(hit.u, hit.v), 0.01 + 0.005);
    }
    const Probe on = secants(0);
    std::uint64_t fewer = 0;
    for (std::size_t i = 0; i < on.work.texels.size(); ++i) {
        ASSERT_LE(ended.work.texels[i].taps, on.work.texels[i].taps);
        fewer += on.work.texels[i].taps - ended.work.texels[i].taps;
    }
    EXPECT_GT(fewer, 2 * on.work.texels.size());
}

/// On a plane, which a layer only comes near.
TEST_F(MarchParameters, ContactRefinementMayEndWithAChord) {
    const CoordinateScene low(device(), map_of({16, 16}, [](int, int) { return 0.33; }));
    const ParameterValues coarse{{"adaptive", false}, {"max_steps", std::int64_t{5}}};
    const auto height = [&](const std::string& answer) {
        return compare("contact_refinement", with(coarse, {{"contact_answer", answer}}), low,
                       repeating(parallel_view(60)))
            .probe.hits.at(40, 40)
            .h;
    };
    EXPECT_NEAR(height("layer"), 0.32, 1e-5) << "the seventeenth of 25 layers";
    EXPECT_NEAR(height("chord"), 0.33, 2e-5);
}

TEST_F(MarchParameters, TheMipChainIsMadeOnlyWhereItIsRead) {
    const CoordinateScene rock(device(), procedural("rock", {64, 64}));
    const Technique pom = shipped("pom");
    const auto prepared = [&](const ParameterValues& changed) {
        Renderer renderer(device(), pom, with_values(pom.manifest, changed), rock.on_device, parallel_view(60),
                          coordinate_lighting());
        return renderer.prepare();
    };
    EXPECT_EQ(prepared({}).bytes, 0U);
    EXPECT_TRUE(prepared({}).pass_ms.empty());
    const Preparation mips = prepared({{"height_lod", std::string("entry")}});
    EXPECT_GE(mips.bytes, 2 * 64 * 64 * 4 / 3U) << "r16, and a third for the levels";
    EXPECT_EQ(mips.pass_ms.size(), 2U);
}

/// Some samplers filter 8-bit heights to 8-bit results, and desktop ones weigh texels in steps of 1/256.
TEST_F(MarchParameters, ExactFilteringReachesTheTruthWhereTheSamplerDoesNot) {
    HeightMapSource source;
    source.name = "waves";
    source.size = {64, 64};
    const CoordinateScene waves(device(), load_height_map(source, HeightFormat::r8));
    const View view = repeating(parallel_view(60, -70));
    ParameterValues values{
        {"adaptive", false}, {"max_steps", std::int64_t{256}}, {"height_filter", std::string("hardware")}};
    const double hardware = compare("pom", values, waves, view).errors.uv_texels->p95;
    values["height_filter"] = std::string("exact");
    const TruthComparison exact = compare("pom", values, waves, view);
    EXPECT_LT(exact.errors.uv_texels->p95, 0.002);
    // A device whose sampler is exact has nothing to lose.
    const double deviation = measure_filter_deviation(device(), HeightFormat::r8);
    if (deviation > 1e-4) {
        EXPECT_GT(hardware, 2 * exact.errors.uv_texels->p95);
    }
    const PixelWork& work = exact.probe.work.at(40, 40);
    EXPECT_EQ(work.texels, 4 * work.taps) << "one gather for each tap";
}

}  // namespace reliefbench::test
