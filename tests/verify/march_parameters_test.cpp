#include "verify_test.hpp"

#include "metrics/error_maps.hpp"

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
