// What the shipped presets do, against what their sources compute, worked out by hand.

#include "core/json.hpp"
#include "verify_test.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace reliefbench::test {

namespace {

class ShippedPresets : public VerifyTest {
protected:
    Probe probe(const std::string& technique, const std::string& preset, const CoordinateScene& scene,
                const View& view) {
        const Manifest manifest = shipped(technique).manifest;
        return compare(technique, values_of_preset(manifest, find_preset(manifest, preset)), scene, view).probe;
    }

    static View view_at(double angle, double tiling = 1) {
        View view = parallel_view(angle);
        view.relief.boundary = Boundary::repeat;
        view.relief.tiling = tiling;
        return view;
    }
};

struct Expected {
    const char* technique;
    const char* preset;
    /// At 0°, 55° and 80° over a floor of h = 0, on which every layer is taken, and refinements take all of their
    /// steps: H = 0.1, 64 texels a side, more pixels than texels. N·V is 1, 0.573576 and 0.173648.
    std::array<std::uint32_t, 3> steps;
    /// Where the ray at 55° is found to meet a plane of h = 0.331, s = 0.669.
    double height;
    /// height_lod
    const char* lod;
};

const Expected table[] = {
    // int(mix(50, 8, N·V)): 8, 25.91, 42.71; the chord of a plane is the plane.
    {"pom", "dx_sdk", {8, 25, 42}, 0.331, "gradients"},
    {"pom", "luna", {8, 25, 42}, 0.331, "gradients"},
    // mix(15, 10, N·V), the last layer thinner: 10, 12.13, 14.13.
    {"pom", "dykhta_pom", {10, 13, 15}, 0.331, "zero"},
    {"pom", "pv227", {15, 15, 15}, 0.331, "zero"},
    // mix(32, 8, N·V): 8, 18.23, 27.83.
    {"pom", "godot_4", {8, 19, 28}, 0.331, "gradients"},
    // mix(16, 1, N·V): 1, 7.40, 13.40.
    {"pom", "bevy", {1, 8, 14}, 0.331, "zero"},
    {"pom", "o3de", {16, 16, 16}, 0.331, "gradients"},
    {"pom", "o3de_ultra", {128, 128, 128}, 0.331, "gradients"},
    // mix(48, 16, N·V): 16, 29.65, 42.44.
    {"pom", "three_silhouette", {16, 30, 43}, 0.331, "zero"},
    // mix(15, 5, N·V): 5, 9.264, 13.26; the seventh of 9.264 layers.
    {"steep", "dykhta_steep", {5, 10, 14}, 0.244406, "zero"},
    // As dykhta_pom, and 5 halvings. From 8/12.132 a 32nd of a layer is 0.0025758: the middle of the fourth.
    {"relief", "dykhta_relief", {15, 18, 20}, 0.331578, "zero"},
    // As bevy, and 5 halvings. From 4/7.3964 a 32nd of a layer is 0.0042251: the middle of the 31st.
    {"relief", "bevy_relief", {6, 13, 19}, 0.330329, "zero"},
    // Half of the texels crossed: none, so that nothing is searched; 64·0.1·tan 55° = 9.140, 4.570; under the slope 5
    // 32, 16; and 5 halvings. From 3/4.570 a 32nd of a layer is 0.0068380: the middle of the second.
    {"relief", "playcanvas", {0, 10, 21}, 0.333298, "entry"},
    // int(mix(16, 4, N·V)): 4, 9.12, 13.92; and 4 halvings. From 6/9 a 16th of a layer is 0.0069444: the first's end.
    {"relief", "ez_engine", {8, 13, 17}, 0.326389, "zero"},
    // 16 layers at no distance, and 15 finer ones before the end that is known.
    {"contact_refinement", "skyrim_community_shaders", {31, 31, 31}, 0.331, "entry"},
    // int(5 + 10·atan(H·tanθ)/90°): 5, 5.90, 8.29; on the floor there is no chord to draw.
    {"secant", "unity_hdrp", {5, 5, 8}, 0.331, "entry"},
};

}  // namespace

TEST_F(ShippedPresets, AreAllHeldToTheirSources) {
    std::set<std::string> shipped_presets;
    for (const std::string& id : shipped_ids()) {
        for (const Preset& preset : shipped(id).manifest.presets)
            EXPECT_TRUE(shipped_presets.insert(preset.name).second) << preset.name << " belongs to two techniques";
    }
    std::set<std::string> expected{"riz"};
    for (const Expected& row : table)
        expected.insert(row.preset);
    EXPECT_EQ(shipped_presets, expected);
}

TEST_F(ShippedPresets, AreAllInTheConfigurationOfEngines) {
    const Json configuration =
        read_json_file(std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "configs" / "engines.json");
    std::set<std::string> there;
    for (const Json& selection : configuration.at("techniques")) {
        if (!selection.is_object() || !selection.contains("preset")) continue;
        for (const Json& preset : selection.at("preset"))
            there.insert(preset.get<std::string>());
    }
    std::set<std::string> shipped_presets;
    for (const std::string& id : shipped_ids()) {
        for (const Preset& preset : shipped(id).manifest.presets)
            shipped_presets.insert(preset.name);
    }
    EXPECT_EQ(there, shipped_presets);
}

TEST_F(ShippedPresets, TakeTheStepsOfTheirSources) {
    const CoordinateScene floor(device(), map_of({64, 64}, [](int, int) { return 0.0; }));
    for (const Expected& row : table) {
        std::array<std::uint32_t, 3> steps{};
        std::ranges::transform(std::array{0.0, 55.0, 80.0}, steps.begin(), [&](double angle) {
            return probe(row.technique, row.preset, floor, view_at(angle)).work.at(40, 40).steps;
        });
        EXPECT_EQ(steps, row.steps) << row.preset;
    }
}

TEST_F(ShippedPresets, RefineAsTheirSourcesDo) {
    const CoordinateScene plane(device(), map_of({64, 64}, [](int, int) { return 0.331; }));
    for (const Expected& row : table) {
        // r16 keeps 0.331 to 1e-5, and samplers what they filter to about as much.
        EXPECT_NEAR(probe(row.technique, row.preset, plane, view_at(55)).hits.at(40, 40).h, row.height, 4e-5)
            << row.preset;
    }
}

/// None is broken by a value that is right on planes alone.
TEST_F(ShippedPresets, FindARelief) {
    const CoordinateScene bumps(device(), map_of({64, 64}, [](int x, int y) {
                                    const double turn = 2 * std::numbers::pi / 64;
                                    return 0.5 + 0.25 * std::sin(turn * 2 * x) + 0.25 * std::cos(turn * y);
                                }));
    const View view = view_at(45);
    const double flat = compare("flat", shipped("flat").manifest.defaults(), bumps, view).errors.uv_texels->mean;
    for (const Expected& row : table) {
        const Manifest manifest = shipped(row.technique).manifest;
        const HitErrors errors =
            compare(row.technique, values_of_preset(manifest, find_preset(manifest, row.preset)), bumps, view).errors;
        // What lies beyond the patch is cut off for an outline: H·tan 45° of it at most.
        EXPECT_LE(errors.missed, row.preset == std::string("three_silhouette") ? 0.1 : 0) << row.preset;
        ASSERT_TRUE(errors.uv_texels) << row.preset;
        // godot_4 goes cos 45° of the way.
        EXPECT_LT(errors.uv_texels->mean, 0.31 * flat) << row.preset;
    }
}

/// Stripes of eight texels in pixels of more than eight: their mean where the level is chosen by the footprint.
TEST_F(ShippedPresets, ReadTheLevelOfTheirSources) {
    const CoordinateScene stripes(device(), map_of({64, 64}, [](int x, int) { return x % 8 < 2 ? 1.0 : 0.2; }));
    for (const Expected& row : table) {
        const std::string preset = row.preset;
        const Manifest manifest = shipped(row.technique).manifest;
        EXPECT_EQ(values_of_preset(manifest, find_preset(manifest, preset)).at("height_lod"),
                  ParameterValue(std::string(row.lod)))
            << preset;
        // The first has faded, and the second reads a level that keeps the stripes.
        if (preset == "dx_sdk" || preset == "skyrim_community_shaders") continue;
        std::vector<float> heights;
        for (const Hit& hit : probe(row.technique, preset, stripes, view_at(60, 13)).hits.texels) {
            if (hit.is_hit()) heights.push_back(hit.h);
        }
        ASSERT_FALSE(heights.empty()) << preset;
        const auto [lowest, highest] = std::ranges::minmax(heights);
        if (std::string(row.lod) == "zero") {
            EXPECT_GT(highest - lowest, 0.3F) << preset;
        } else {
            // A chord, or what halvings leave of a layer.
            EXPECT_LT(highest - lowest, 0.02F) << preset;
            EXPECT_NEAR(lowest, 0.4, 0.02) << preset;
        }
    }
}

/// 0.04·h − 0.02 along V.xy at a height scale of 0.04.
TEST_F(ShippedPresets, OfParallaxMappingMoveCoordinatesAsPublished) {
    View view = view_at(55);
    view.relief.height_scale = 0.04;
    const double xy = std::sin(55 * std::numbers::pi / 180);
    for (const double h : {0.0, 0.25, 1.0}) {
        const CoordinateScene flat(device(), map_of({16, 16}, [&](int, int) { return h; }));
        const Hit hit = probe("parallax", "riz", flat, view).hits.at(40, 40);
        // Seen from −v: the eye's direction is that of −v.
        EXPECT_NEAR(hit.v - footprint_entry(pixel_ray(view, 40, 40))->y, -(0.04 * h - 0.02) * xy, 1e-5) << h;
    }
}

}  // namespace reliefbench::test
