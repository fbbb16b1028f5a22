#include "configuration_text.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string plain_text = with(R"("axes": {"heightmap": "rock"})", R"(["plain", "march"])");

TEST(Configuration, SettingsThatAreLeftOutKeepTheirDefaults) {
    const Configuration configuration = parse(plain_text);
    EXPECT_EQ(configuration.name, "test");
    EXPECT_EQ(configuration.seed, 1U);
    EXPECT_EQ(configuration.truth.kind, TruthSettings::Kind::exact);
    EXPECT_EQ(configuration.truth.samples, 1);
    EXPECT_EQ(configuration.sampling.rule, SamplingSettings::Rule::precision);
    EXPECT_EQ(configuration.sampling.rounds, SamplingSettings{}.rounds);
    EXPECT_EQ(configuration.lighting.lights.size(), 1U);
    EXPECT_FALSE(configuration.images);
    EXPECT_FALSE(configuration.motion);
}

TEST(Configuration, TheCameraMovesFromTheCellsOwnView) {
    const MotionSettings towards_head_on = *parse(with_member(R"("motion": {"degrees": 2})")).motion;
    EXPECT_EQ(towards_head_on.frames, MotionSettings{}.frames);
    Camera camera;
    camera.view_angle = 3;
    EXPECT_EQ(camera_in_motion(camera, towards_head_on, 0), camera);
    EXPECT_EQ(camera_in_motion(camera, towards_head_on, 2).view_angle, -1);
    const MotionSettings around = *parse(with_member(R"("motion": {"along": "azimuth"})")).motion;
    EXPECT_EQ(camera_in_motion(camera, around, 4).azimuth, camera.azimuth + 1);
    EXPECT_EQ(camera_in_motion(camera, around, 4).view_angle, 3);
}

TEST(Configuration, StoppingRulesAreRead) {
    const SamplingSettings precision =
        parse(with_member(R"("sampling": {"rule": "precision", "rounds": 6, "precision": 0.05, "budget_s": 1.5})"))
            .sampling;
    EXPECT_EQ(precision.rule, SamplingSettings::Rule::precision);
    EXPECT_EQ(precision.rounds, 6);
    EXPECT_EQ(precision.precision, 0.05);
    EXPECT_EQ(precision.budget_s, 1.5);
    const SamplingSettings time = parse(with_member(R"("sampling": {"rule": "time", "rounds": 1})")).sampling;
    EXPECT_EQ(time.rule, SamplingSettings::Rule::time);
}

TEST(Configuration, SettingsAreRead) {
    const Configuration configuration = parse(with_member(R"("$schema": "schema.json", "name": "all", "seed": 9,
        "truth": {"kind": "mesh", "subdivision": 8, "samples": 64}, "images": true,
        "sampling": {"rule": "fixed", "rounds": 7, "samples_per_visit": 6, "warm_up": 0, "minimum_pass_ms": 0.5},
        "lighting": {"lights": [{"direction": [0, 0, 2], "colour": [1, 2, 3]}, {}], "ambient": [0, 0, 0],
                     "specular": [0.5, 0.5, 0.5], "shininess": 8, "enabled": false, "background": [1, 0, 0],
                     "fog": {"start": 2, "range": 3, "colour": [0, 1, 0]}})"));
    EXPECT_EQ(configuration.name, "all");
    EXPECT_EQ(configuration.seed, 9U);
    EXPECT_EQ(configuration.truth.kind, TruthSettings::Kind::mesh);
    EXPECT_EQ(configuration.truth.subdivision, 8);
    EXPECT_EQ(configuration.truth.samples, 64);
    EXPECT_TRUE(configuration.images);
    EXPECT_EQ(configuration.sampling.rule, SamplingSettings::Rule::fixed);
    EXPECT_EQ(configuration.sampling.rounds, 7);
    EXPECT_EQ(configuration.sampling.samples_per_visit, 6);
    EXPECT_EQ(configuration.sampling.warm_up, 0);
    EXPECT_EQ(configuration.sampling.minimum_pass_ms, 0.5);
    const Lighting& lighting = configuration.lighting;
    ASSERT_EQ(lighting.lights.size(), 2U);
    EXPECT_EQ(lighting.lights[0].direction, glm::dvec3(0, 0, 2));
    EXPECT_EQ(lighting.lights[0].colour, glm::dvec3(1, 2, 3));
    EXPECT_EQ(lighting.lights[1].direction, DirectionalLight{}.direction);
    EXPECT_EQ(lighting.specular, glm::dvec3(0.5));
    EXPECT_EQ(lighting.shininess, 8);
    EXPECT_FALSE(lighting.enabled);
    EXPECT_EQ(lighting.background, glm::dvec3(1, 0, 0));
    EXPECT_EQ(lighting.fog->range, 3);
}

struct Bad {
    std::string text;
    const char* message;
};

TEST(Configuration, WhatIsWrongIsNamedWithItsPlace) {
    const Bad cases[] = {
        {with_member(R"("imges": true)"), "test.json: $: unknown key \"imges\" (did you mean 'images'?)"},
        {R"({"axes": {"heightmap": "rock"}})", "test.json: $: key \"techniques\" is missing"},
        {R"({"techniques": ["plain"]})", "test.json: $: key \"axes\" is missing"},
        {with(R"("axes": {"view_angle": 0})"), "test.json: $.axes: the axis \"heightmap\" is missing"},
        {with(R"("axes": {"heightmap": "rock"})", "[]"), "$.techniques: select at least one technique"},
        {with(R"("axes": {"heightmap": "rock"})", R"(["plain", "marsh"])"),
         "$.techniques[1]: unknown technique 'marsh' (did you mean 'march'?)"},
        {with(R"("axes": {"heightmap": "rock"})", R"([{"technique": "tree", "parameters": {"lea": "exact"}}])"),
         "$.techniques[0].parameters.lea: the technique tree has no parameter 'lea' (did you mean 'leaf'?)"},
        {with(R"("axes": {"heightmap": "rock"})", R"([{"technique": "tree", "parameters": {"max_steps": [64, 8]}}])"),
         "$.techniques[0].parameters.max_steps[1]: max_steps cannot be 8: it is an integer from 16 to 4096"},
        {with(R"("axes": {"heightmap": "rock"})", R"([{"technique": "tree", "parameters": {"leaf": []}}])"),
         "$.techniques[0].parameters.leaf: expected at least one value"},
        {with(R"("axes": {"heightmap": "rock"})", R"([{"technique": "tree", "parameter": {}}])"),
         "unknown key \"parameter\" (did you mean 'parameters'?)"},
        {with(R"("axes": {"heightmap": "rok"})"),
         "$.axes.heightmap: 'rok' is neither a procedural height map (did you "
         "mean 'rock'?)"},
        {with(R"("axes": {"heightmap": {"name": "rok"}})"),
         "$.axes.heightmap.name: no procedural height map 'rok' (did you mean 'rock'?)"},
        {with(R"("axes": {"heightmap": {"file": "none.png"}})"), "$.axes.heightmap.file: no file 'none.png' in"},
        {with(R"("axes": {"heightmap": {"name": "rock", "albedo": "none.png"}})"), "$.axes.heightmap.albedo: no file"},
        {with(R"("axes": {"heightmap": {"name": "rock", "invert": true}})"),
         "$.axes.heightmap.invert: it applies to files only"},
        {with(R"("axes": {"heightmap": {"file": "a.png", "seed": 2}})"),
         "$.axes.heightmap.seed: it applies to procedural height maps only"},
        {with(R"("axes": {"heightmap": {"file": "a.png", "chanel": 2}})"), "(did you mean 'channel'?)"},
        {with(R"("axes": {"heightmap": {"seed": 2}})"), "$.axes.heightmap: give either \"name\""},
        {with(R"("axes": {"heightmap": {"file": "a.png", "normalize": true, "height_range": [0, 2]}})"),
         "give either normalize or height_range"},
        {with(R"("axes": {"heightmap": {"name": "rock", "fill": 0}})"),
         "$.axes.heightmap.fill: it applies to files only"},
        {with(R"("axes": {"heightmap": {"file": "a.png", "channel": ""}})"),
         "$.axes.heightmap.channel: expected a name, or a number from 0"},
        {with(R"("axes": {"heightmap": {"file": "a.png", "part": -1}})"), "$.axes.heightmap.part: expected an integer"},
        {with(R"("axes": {"heightmap": {"file": "a.png", "byte_order": "big"}})"),
         "$.axes.heightmap.byte_order: it applies to files without a header"},
        {with(R"("axes": {"heightmap": {"file": "a.r16", "size": 4, "sample_type": "word"}})"),
         "$.axes.heightmap.sample_type: expected one of uint8, uint16, int16, float32"},
        {with(R"("axes": {"heightmap": {"file": "a.r16", "size": 4, "channel": 1}})"),
         "$.axes.heightmap.channel: it applies to images"},
        {with(R"("axes": {"heightmap": {"file": "a.png", "packing": "rg16", "channel": 1}})"),
         "$.axes.heightmap.channel: packing says which channels are read"},
        {with(R"("axes": {"heightmap": {"file": "a.png", "height_range": [1, 0]}})"),
         "$.axes.heightmap.height_range: expected two numbers, the first below the second"},
        {with_axis(R"("view_angel": 3)"),
         "test.json: $.axes.view_angel: unknown axis 'view_angel': neither of the view "
         "nor a parameter of a technique selected (did you mean 'view_angle'?)"},
        {with_axis(R"("factor": 3)"),
         "$.axes.factor: none of the techniques selected has a parameter 'factor', but mesh "
         "has; select it"},
        {with_axis(R"("view_angle": [0, 90])"),
         "$.axes.view_angle[1]: expected a number from 0 to below 90, "
         "found 90"},
        {with_axis(R"("view_angle": -1)"), "$.axes.view_angle: expected"},
        {with_axis(R"("view_angle": "60")"), "$.axes.view_angle: expected a number from 0 to below 90"},
        {with_axis(R"("view_angle": [])"), "$.axes.view_angle: expected at least one value"},
        {with_axis(R"("projection": "paralel")"), "(did you mean 'parallel'?)"},
        {with_axis(R"("resolution": "0x256")"),
         "$.axes.resolution: expected a size such as 256 or \"512x256\", each "
         "side from 1 to 16384, found \"0x256\""},
        {with_axis(R"("resolution": 0)"), "$.axes.resolution: expected an integer from 1 to 16384"},
        {with_axis(R"("resolution": "100000x100000")"), "each side from 1 to 16384"},
        {with_axis(R"("resolution": "256x")"), "$.axes.resolution: expected a size"},
        {with_axis(R"("resolution": 256.5)"), "$.axes.resolution: expected an integer"},
        {with_axis(R"("heightmap_size": -4)"), "$.axes.heightmap_size: expected an integer from 1 to 16384"},
        {with_axis(R"("height_scale": 0)"), "$.axes.height_scale: expected a number above 0, up to 10"},
        {with_axis(R"("tiling": -1)"), "$.axes.tiling: expected a number above 0, up to 1024"},
        {with_axis(R"("fov": 180)"), "$.axes.fov: expected a number from 1 to 170"},
        {with_axis(R"("azimuth": 400)"), "$.axes.azimuth: expected a number from -360 to 360"},
        {with_axis(R"("distance": 0)"), "$.axes.distance: expected a number above 0"},
        {with_axis(R"("height_format": "r17")"), "$.axes.height_format"},
        {with_axis(R"("boundary": "wrap")"), "$.axes.boundary"},
        {with_axis(R"("sample_count": 0)"), "$.axes.sample_count: expected an integer from 1"},
        {with_axis(R"("sample_count": [8, 100000])"),
         "$.axes.sample_count[1]: no technique selected takes this value: "
         "max_steps cannot be 100000: it is an integer from 1 to 256"},
        {with_axis(R"("leaf": ["exact", "exat"])"),
         "$.axes.leaf[1]: no technique selected takes this value: leaf cannot be exat"},
        {with_axis(R"("leaf": [null])"), "$.axes.leaf: expected a boolean, a number or a string"},
        {with(R"("axes": {"heightmap": "rock", "sample_count": 8})", R"(["plain"])"),
         "$.axes.sample_count: none of the techniques selected has a sample count"},
        {with_member(R"("zip": [["view_angle", "azimuth"]])"),
         "$.zip[0]: axes tied together need equally many values: view_angle has 2, azimuth has 3"},
        {with_member(R"("zip": [["view_angle", "azimut"]])"),
         "$.zip[0]: 'azimut' is no axis of this configuration (did you mean 'azimuth'?)"},
        {with_member(R"("zip": [["view_angle"]])"), "$.zip[0]: a zip ties at least two axes"},
        {with_member(R"("zip": [["view_angle", "view_angle"]])"), "$.zip[0]: the axis 'view_angle' is tied twice"},
        {with_member(R"("exclude": [{"view_angel": 60}])"), "$.exclude[0].view_angel: 'view_angel' is neither"},
        {with_member(R"("exclude": [{"view_angle": 95}])"),
         "$.exclude[0].view_angle: expected a number from 0 to below 90"},
        {with_member(R"("exclude": [{"technique": "marsh"}])"), "$.exclude[0].technique: unknown technique 'marsh'"},
        {with_member(R"("exclude": [{"leaf": "exat"}])"), "$.exclude[0].leaf: leaf cannot be exat"},
        {with_member(R"("exclude": [{}])"), "$.exclude[0]: expected at least one condition"},
        {with_member(R"("exclude": [{"heightmap": "rock"}])"), "test.json: no cell is left"},
        {with_member(R"("seed": -1)"), "$.seed: expected an integer of at least 0"},
        {with_member(R"("truth": {"kind": "exakt"})"), "$.truth.kind"},
        {with_member(R"("truth": {"subdivision": 0})"), "$.truth.subdivision: expected an integer from 1 to 64"},
        {with_member(R"("truth": {"samples": 1025})"), "$.truth.samples: expected an integer from 1 to 1024"},
        {with_member(R"("sampling": {"rule": "entropy"})"), "$.sampling.rule"},
        {with_member(R"("sampling": {"rounds": 0})"), "$.sampling.rounds: expected an integer from 1"},
        {with_member(R"("sampling": {"rounds": 5})"), "$.sampling.rounds: expected at least 6 rounds for the rule"},
        {with_member(R"("sampling": {"precision": 0})"), "$.sampling.precision: expected a number"},
        {with_member(R"("sampling": {"rule": "time", "budget_s": 0})"),
         "$.sampling.budget_s: expected seconds above 0"},
        {with_member(R"("lighting": {"lights": [{}, {}, {}, {}]})"), "$.lighting.lights: expected at most 3 lights"},
        {with_member(R"("lighting": {"lights": [{"direction": [0, 0, 0]}]})"),
         "$.lighting.lights[0].direction: expected a direction that is not zero"},
        {with_member(R"("lighting": {"ambient": [0.1, 0.1]})"), "$.lighting.ambient: expected three numbers"},
        {with_member(R"("lighting": {"fog": {"range": 0}})"), "$.lighting.fog.range: expected a length above 0"},
        {with_member(R"("motion": {"degrees": 0})"), "$.motion.degrees: expected degrees above 0"},
        {with_member(R"("motion": {"neighbourhood_clamp": true})"),
         "$.motion.neighbourhood_clamp: expected a history_weight beside it"},
        {with_member(R"("motion": {"history_weight": 1})"), "$.motion.history_weight: expected a number"},
        {with_member(R"("motion": {"frames": 1000})"),
         "$.motion: expected an arc of at most 60 degrees, (frames - 1) * degrees"},
        {with_member(R"("images": "yes")"), "$.images: expected true or false"},
        {"[]", "test.json: $: expected an object"},
    };
    for (const Bad& bad : cases)
        EXPECT_THAT(message_of(bad.text), HasSubstr(bad.message)) << bad.text;
}

TEST(Configuration, MalformedJsonNamesFileAndPosition) {
    EXPECT_THAT(message_of("{\n  \"techniques\": [,]\n}"), HasSubstr("test.json:2:"));
    EXPECT_THAT(message_of(with(R"("axes": {"heightmap": "rock", "view_angle": 0, "view_angle": 60})")),
                HasSubstr("duplicate key \"view_angle\""));
}

TEST(Configuration, TooManyCellsAreRefusedBeforeTheyAreMade) {
    Json json = parse_json(plain_text, "test");
    for (const char* axis : {"view_angle", "fov", "azimuth"}) {
        for (int value = 1; value < 89; ++value)
            json["axes"][axis].push_back(value);
    }
    // 88³ views of two techniques.
    EXPECT_THAT(message_of(json.dump()), HasSubstr("1362944 cells are more than 1000000"));
}

TEST(Sampling, IsSetByName) {
    Configuration configuration = parse(with(R"("axes": {"heightmap": "rock"})", R"(["plain"])"));
    set_sampling(configuration, {"rule=fixed,rounds=3", "warm_up=0"});
    EXPECT_EQ(configuration.sampling.rule, SamplingSettings::Rule::fixed);
    EXPECT_EQ(configuration.sampling.rounds, 3);
    EXPECT_EQ(configuration.sampling.warm_up, 0);
    EXPECT_EQ(configuration.sampling.precision, SamplingSettings{}.precision);
    EXPECT_EQ(configuration.expanded.at("sampling").at("rounds"), 3);
    const auto message = [&](const std::string& setting) {
        return error_message([&] { set_sampling(configuration, {setting}); });
    };
    EXPECT_THAT(message("round=3"), AllOf(HasSubstr("--sampling round=3"), HasSubstr("did you mean 'rounds'")));
    EXPECT_THAT(message("rule=precision"), HasSubstr("expected at least 6 rounds"));
    EXPECT_THAT(message("rounds=many"), HasSubstr("expected an integer"));
    EXPECT_THAT(message("rounds"), HasSubstr("expected name=value"));
}

TEST(Configuration, ReadsBackFromWhatIsWrittenToRunJson) {
    const std::string text = with(
        R"("name": "round", "seed": 5, "images": true, "motion": {"degrees": 1, "history_weight": 0.9}, "zip": [["view_angle", "azimuth"]],
        "axes": {"heightmap": ["rock", {"name": "bricks", "size": "64x32", "seed": 3}], "view_angle": [0, 60],
                 "azimuth": [0, 22.5], "sample_count": [16, 32]}, "exclude": [{"technique": "plain", "view_angle": 60}],
        "truth": {"kind": "mesh", "samples": 16}, "lighting": {"fog": {}, "shininess": 3}, "sampling": {"rounds": 7}, "preparation": {"limit_s": 5})",
        R"(["plain", "march", {"technique": "tree", "parameters": {"leaf": ["exact"]}}])");
    const Configuration first = parse(text, {"view_angle=10,60"});
    Json run = Json::object();
    run["command_line"] = "reliefbench run";
    run["configuration"] = first.expanded;
    const Configuration second = parse(run.dump());
    EXPECT_EQ(second.expanded, first.expanded);
    EXPECT_EQ(ids(second), ids(first));
    EXPECT_EQ(second.name, "round");
    EXPECT_EQ(second.lighting.fog->start, Fog{}.start);
    run["configuration"]["seed"] = "x";
    EXPECT_THAT(message_of(run.dump()), HasSubstr("test.json: $.configuration.seed"));
}

}  // namespace
}  // namespace reliefbench
