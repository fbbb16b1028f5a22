#include "sweep/configuration.hpp"
#include "sweep/override_effects.hpp"

#include "core/file.hpp"
#include "fake_techniques.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <limits>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Configuration parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_configuration(parse_json(text, "test.json"), "test.json", overrides, fake_techniques());
}

std::vector<std::string> ids(const Configuration& configuration) {
    std::vector<std::string> found;
    for (const Cell& cell : expand(configuration, fake_techniques()))
        found.push_back(cell.id);
    return found;
}

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return error_message([&] { ids(parse(text, overrides)); });
}

/// A configuration that is right but for `members`.
std::string with(const std::string& members, const std::string& techniques = R"(["plain", "march", "tree"])") {
    return R"({"techniques": )" + techniques + R"(, )" + members + "}";
}

std::string with_axis(const std::string& axis) {
    return with(R"("axes": {"heightmap": "rock", )" + axis + "}");
}

std::string with_member(const std::string& member) {
    return with(R"("axes": {"heightmap": "rock", "view_angle": [0, 60], "azimuth": [0, 45, 90]}, )" + member);
}

const std::string plain_text = with(R"("axes": {"heightmap": "rock"})", R"(["plain", "march"])");

TEST(Configuration, SettingsThatAreLeftOutKeepTheirDefaults) {
    const Configuration configuration = parse(plain_text);
    EXPECT_EQ(configuration.name, "test");
    EXPECT_EQ(configuration.seed, 1U);
    EXPECT_EQ(configuration.truth.kind, TruthSettings::Kind::exact);
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
        "truth": {"kind": "mesh", "subdivision": 8}, "images": true,
        "sampling": {"rule": "fixed", "rounds": 7, "samples_per_visit": 6, "warm_up": 0, "minimum_pass_ms": 0.5},
        "lighting": {"lights": [{"direction": [0, 0, 2], "colour": [1, 2, 3]}, {}], "ambient": [0, 0, 0],
                     "specular": [0.5, 0.5, 0.5], "shininess": 8, "enabled": false, "background": [1, 0, 0],
                     "fog": {"start": 2, "range": 3, "colour": [0, 1, 0]}})"));
    EXPECT_EQ(configuration.name, "all");
    EXPECT_EQ(configuration.seed, 9U);
    EXPECT_EQ(configuration.truth.kind, TruthSettings::Kind::mesh);
    EXPECT_EQ(configuration.truth.subdivision, 8);
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

TEST(Overrides, ReplaceAddAndAreNamedInMessages) {
    const std::string text = with(R"("axes": {"heightmap": "rock", "view_angle": [10, 20]})", R"(["plain"])");
    EXPECT_THAT(ids(parse(text, {"view_angle=0,60", "tiling=2"})),
                ElementsAre("plain | heightmap=rock tiling=2", "plain | heightmap=rock view_angle=60 tiling=2"));
    EXPECT_THAT(ids(parse(text, {"heightmap=bricks", "view_angle=[0:80:80]"})),
                ElementsAre("plain | heightmap=bricks", "plain | heightmap=bricks view_angle=80"));
    EXPECT_THAT(message_of(text, {"view_angle=95"}),
                HasSubstr("-a view_angle=95: view_angle: expected a number from 0 to below 90, found 95"));
    EXPECT_THAT(message_of(text, {"view_angel=5"}), AllOf(HasSubstr("-a view_angel=5"), HasSubstr("'view_angle'")));
    EXPECT_THAT(message_of(text, {"heightmap=rok"}), AllOf(HasSubstr("-a heightmap=rok"), HasSubstr("'rock'")));
    EXPECT_THAT(message_of(text, {"view_angle=5", "view_angle=6"}),
                HasSubstr("-a view_angle=6: 'view_angle' is given twice, first as -a view_angle=5"));
    EXPECT_THAT(message_of(text, {"resolution=0x0"}), HasSubstr("-a resolution=0x0: resolution: expected a size"));
}

TEST(Overrides, OfAParameterReplaceItWhereverItIsSet) {
    const std::string text =
        with(R"("axes": {"heightmap": "rock", "sample_count": [16, 128]})",
             R"([{"technique": "tree", "parameters": {"max_steps": 99, "leaf": "linear"}}, "march"])");
    EXPECT_THAT(ids(parse(text, {"max_steps=17"})),
                ElementsAre("tree max_steps=17 leaf=linear | heightmap=rock", "march max_steps=17 | heightmap=rock"));
    EXPECT_THAT(ids(parse(text, {"sample_count=20"})), ElementsAre("tree max_steps=20 leaf=linear | heightmap=rock",
                                                                   "march max_steps=20 min_steps=5 | heightmap=rock"));
    EXPECT_THAT(ids(parse(text, {"leaf=exact", "sample_count=20"})),
                ElementsAre("tree max_steps=20 | heightmap=rock", "march max_steps=20 min_steps=5 | heightmap=rock"));
}

TEST(Overrides, OfATiedAxisHoldForAllThatItWasTiedTo) {
    const std::string text = with(R"("axes": {"heightmap": ["rock", "bricks", "rock"], "view_angle": [0, 30, 60],
        "tiling": [1, 2, 2]}, "zip": [["heightmap", "view_angle", "tiling"]])",
                                  R"(["plain"])");
    EXPECT_THAT(ids(parse(text)),
                ElementsAre("plain | heightmap=rock", "plain | heightmap=bricks view_angle=30 tiling=2",
                            "plain | heightmap=rock view_angle=60 tiling=2"));
    EXPECT_THAT(ids(parse(text, {"view_angle=60"})),
                ElementsAre("plain | heightmap=rock view_angle=60", "plain | heightmap=bricks view_angle=60 tiling=2",
                            "plain | heightmap=rock view_angle=60 tiling=2"));
    EXPECT_THAT(ids(parse(text, {"view_angle=5", "heightmap=rock"})),
                ElementsAre("plain | heightmap=rock view_angle=5", "plain | heightmap=rock view_angle=5 tiling=2"));
}

/// What is told of overrides once filters are applied.
std::string warnings_of(const std::string& text, const std::vector<std::string>& overrides,
                        const std::vector<std::string>& filters = {}) {
    const Configuration configuration = parse(text, overrides);
    const std::vector<Cell> cells = filter_cells(expand(configuration, fake_techniques()), filters, fake_techniques());
    testing::internal::CaptureStderr();
    warn_of_overrides(configuration, cells, fake_techniques());
    return testing::internal::GetCapturedStderr();
}

const std::string tied_views = with(
    R"("axes": {"heightmap": ["rock", "bricks", "rock"], "projection": ["parallel", "parallel", "perspective"],
    "view_angle": [0, 45, 60], "azimuth": [-67, -45, -67]},
    "zip": [["heightmap", "projection", "view_angle", "azimuth"]])",
    R"(["plain"])");

TEST(Overrides, ThatTakeAxesOutOfTheirZipAreToldOnceWithWhatToDo) {
    EXPECT_EQ(warnings_of(tied_views, {"heightmap=spikes", "view_angle=70", "resolution=128x72"}),
              "warning: -a heightmap=spikes -a view_angle=70: the configuration ties heightmap and "
              "view_angle to projection and azimuth (\"zip\"); with values of their own they are tied no more, and "
              "combined with each of the 3 combinations of projection and azimuth; give -a projection=... "
              "-a azimuth=... too, or --filter projection=perspective\n");
    EXPECT_THAT(warnings_of(tied_views, {"heightmap=spikes", "view_angle=70", "projection=parallel"}),
                HasSubstr("combined with each of the 2 values of azimuth; give -a azimuth=... too, or --filter "
                          "azimuth=-67"))
        << "one axis is left";
    const std::string pair = with(
        R"("axes": {"heightmap": "rock", "view_angle": [0, 60], "tiling": [1, 2]}, "zip": [["view_angle", "tiling"]])",
        R"(["plain"])");
    EXPECT_THAT(warnings_of(pair, {"view_angle=30"}),
                AllOf(HasSubstr("-a view_angle=30: the configuration ties view_angle to tiling (\"zip\")"),
                      HasSubstr("it is tied no more")));
    EXPECT_EQ(warnings_of(pair, {"heightmap=bricks"}), "");
}

TEST(Overrides, OfAZipThatLeaveOneValueOfTheOthersAreWhatWasAskedFor) {
    EXPECT_EQ(warnings_of(tied_views, {"heightmap=spikes", "view_angle=0,70", "projection=parallel", "azimuth=3"}), "");
    EXPECT_EQ(warnings_of(tied_views, {"heightmap=spikes", "view_angle=70"}, {"projection=perspective"}), "");
    const std::string same = with(
        R"("axes": {"heightmap": "rock", "view_angle": [0, 60], "tiling": [2, 2]}, "zip": [["view_angle", "tiling"]])",
        R"(["plain"])");
    EXPECT_EQ(warnings_of(same, {"view_angle=30"}), "");
}

TEST(Overrides, OfAZipAreNotToldBeforeAnErrorOfAValue) {
    testing::internal::CaptureStderr();
    EXPECT_THROW(parse(tied_views, {"heightmap=spikes", "view_angle=95"}), Error);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Overrides, ThatChangeNoCellThatIsLeftSaySo) {
    const std::string text =
        with(R"("axes": {"heightmap": "rock", "sample_count": [8, 16]})", R"(["plain", "march", "mesh"])");
    EXPECT_EQ(warnings_of(text, {"sample_count=9", "max_steps=40"}),
              "warning: -a sample_count=9: no cell that is left has a value given here: sample_count is 40 "
              "there, as the axis 'max_steps' goes before it\n");
    EXPECT_EQ(warnings_of(text, {"factor=4"}, {"technique=march"}),
              "warning: -a factor=4: no cell that is left has a value given here: no technique that is left "
              "has a parameter 'factor'\n");
    EXPECT_THAT(
        warnings_of(text, {"distance=2", "projection=parallel"}),
        HasSubstr("-a distance=2: no cell that is left has a value given here: no view that is left has a use"));
    EXPECT_THAT(warnings_of(text, {"sample_count=9"}, {"technique=mesh"}),
                HasSubstr("no technique that is left has a sample count"));
    EXPECT_EQ(warnings_of(text, {"factor=4", "sample_count=16", "view_angle=0,60", "heightmap=bricks"}), "");
    EXPECT_EQ(warnings_of(text, {"technique=march"}), "");
}

TEST(Overrides, OfAnUnknownAxisSayWhatItIsCalledHere) {
    const std::string text = with(R"("axes": {"heightmap": "rock"})", R"(["march"])");
    struct Word {
        const char* override;
        const char* answer;
    };
    const Word words[] = {
        {"samples=8", "called sample_count"},
        {"steps=8", "called sample_count"},
        {"layers=8", "called sample_count"},
        {"angle=8", "called view_angle or azimuth"},
        {"size=8", "called heightmap_size or resolution"},
        {"depth=8", "called height_scale or depth_write"},
        {"Shadows=hard", "called self_shadow"},
        {"rounds=8", "--sampling rounds=..."},
        {"lighting=8", "stands in a configuration beside its axes"},
        {"tilling=8", "did you mean 'tiling'"},
        {"qwertz=8", "`reliefbench list axes`"},
    };
    for (const Word& word : words)
        EXPECT_THAT(message_of(text, {word.override}), HasSubstr(word.answer)) << word.override;
    EXPECT_THAT(
        error_message([&] { filter_cells(expand(parse(text), fake_techniques()), {"samples=8"}, fake_techniques()); }),
        HasSubstr("called sample_count"));
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

TEST(Overrides, OfTechniquesKeepTheParametersOfThoseSelectedBefore) {
    const std::string text = with(R"("axes": {"heightmap": "rock"})",
                                  R"(["plain", {"technique": "tree", "parameters": {"leaf": "linear"}}])");
    EXPECT_THAT(ids(parse(text, {"technique=tree,mesh"})),
                ElementsAre("tree leaf=linear | heightmap=rock", "mesh | heightmap=rock"));
    EXPECT_THAT(message_of(text, {"technique=tre"}), HasSubstr("-a technique=tre: technique: unknown technique 'tre'"));
}

TEST(Configuration, ReadsBackFromWhatIsWrittenToRunJson) {
    const std::string text = with(
        R"("name": "round", "seed": 5, "images": true, "motion": {"degrees": 1}, "zip": [["view_angle", "azimuth"]],
        "axes": {"heightmap": ["rock", {"name": "bricks", "size": "64x32", "seed": 3}], "view_angle": [0, 60],
                 "azimuth": [0, 22.5], "sample_count": [16, 32]}, "exclude": [{"technique": "plain", "view_angle": 60}],
        "truth": {"kind": "mesh"}, "lighting": {"fog": {}, "shininess": 3}, "sampling": {"rounds": 7}, "preparation": {"limit_s": 5})",
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

/// A folder of its own with height map files (nothing reads them here), and a working directory beside it.
class ConfigurationFiles : public testing::Test {
protected:
    ConfigurationFiles() : before_(fs::current_path()) {
        for (const char* folder : {"configs/maps", "here", "other"})
            fs::create_directories(root_ / folder);
        for (const char* file : {"configs/here.png", "configs/both.png", "configs/maps/deep.png", "here/both.png",
                                 "here/there.png", "other/both.png", "here/skin.jpg"}) {
            write_text_file(root_ / file, "not read");
        }
        fs::current_path(root_ / "here");
    }
    ~ConfigurationFiles() override { fs::current_path(before_); }

    Configuration read(const std::string& heightmap, const std::vector<std::string>& overrides = {}) {
        const std::string text = with(R"("axes": {"heightmap": )" + heightmap + "}", R"(["plain"])");
        write_text_file(root_ / "configs" / "test.json", text);
        const std::filesystem::path file = root_ / "configs" / "test.json";
        return parse_configuration(read_json_file(file), file.string(), overrides, fake_techniques());
    }
    std::string source(const Configuration& configuration) {
        return expand(configuration, fake_techniques()).front().view.height_map.name;
    }

    const fs::path before_;
    const TemporaryFolder root_;
};

TEST_F(ConfigurationFiles, AreSoughtBesideTheConfigurationThenInTheWorkingDirectory) {
    EXPECT_EQ(source(read(R"("here.png")")), (root_ / "configs/here.png").string());
    EXPECT_EQ(source(read(R"("maps/deep.png")")), (root_ / "configs/maps/deep.png").string());
    EXPECT_EQ(source(read(R"("both.png")")), (root_ / "configs/both.png").string());
    EXPECT_EQ(source(read(R"("there.png")")), (root_ / "here/there.png").string());
    EXPECT_EQ(source(read(R"({"file": "../here/both.png"})")), (root_ / "here/both.png").string());
    EXPECT_THROW(read(R"("nowhere.png")"), Error);
}

TEST_F(ConfigurationFiles, OfOverridesAreSoughtInTheWorkingDirectory) {
    EXPECT_EQ(source(read(R"("rock")", {"heightmap=both.png"})), (root_ / "here/both.png").string());
    EXPECT_THROW(read(R"("rock")", {"heightmap=here.png"}), Error);
}

TEST_F(ConfigurationFiles, AreCalledByTheirBaseNameAndHowTheyAreRead) {
    const Configuration configuration = read(R"(["there.png", {"file": "there.png", "channel": 2, "invert": true},
        {"file": "there.png", "normalize": true}, {"file": "there.png", "height_range": [0.1, 2], "albedo": "skin.jpg"}])");
    EXPECT_THAT(ids(configuration),
                ElementsAre("plain | heightmap=there.png", "plain | heightmap=there.png+channel=2+invert",
                            "plain | heightmap=there.png+normalize",
                            "plain | heightmap=there.png+height_range=0.1:2+albedo=skin.jpg"));
    const std::vector<Cell> cells = expand(configuration, fake_techniques());
    EXPECT_TRUE(cells[1].view.height_map.invert);
    EXPECT_EQ(cells[1].view.height_map.channel, "2");
    EXPECT_EQ(cells[3].view.height_map.albedo, (root_ / "here/skin.jpg").string());
    EXPECT_EQ(axes_to_json(cells[0].view)["heightmap_size"], Json());
    // Asked for by base name, all readings of the file answer.
    EXPECT_EQ(filter_cells(cells, {"heightmap=there.png"}, fake_techniques()).size(), 4U);
    EXPECT_EQ(filter_cells(cells, {"heightmap=there.png+normalize"}, fake_techniques()).size(), 1U);
    EXPECT_EQ(read(configuration.expanded["axes"]["heightmap"].dump()).expanded, configuration.expanded);
}

TEST_F(ConfigurationFiles, SayHowTheyAreRead) {
    const Configuration configuration = read(R"([
        {"file": "there.png", "part": "height", "channel": "Z"}, {"file": "there.png", "part": 1, "channel": 0},
        {"file": "there.png", "packing": "rg16", "nodata": -32768, "fill": 0.5},
        {"file": "there.png", "size": "8x4", "sample_type": "int16", "byte_order": "big"},
        {"file": "there.png", "size": 4}])");
    EXPECT_THAT(ids(configuration),
                ElementsAre("plain | heightmap=there.png+part=height+channel=Z", "plain | heightmap=there.png+part=1",
                            "plain | heightmap=there.png+packing=rg16+nodata=-32768+fill=0.5",
                            "plain | heightmap=there.png+size=8x4+sample_type=int16+byte_order=big",
                            "plain | heightmap=there.png+size=4x4"));
    const std::vector<Cell> cells = expand(configuration, fake_techniques());
    EXPECT_EQ(cells[2].view.height_map.packing, Packing::rg16);
    ASSERT_TRUE(cells[3].view.height_map.raw);
    EXPECT_EQ(*cells[3].view.height_map.raw,
              (RawLayout{.size = {8, 4}, .sample_type = RawLayout::SampleType::int16, .big_endian = true}));
    EXPECT_EQ(cells[3].view.height_map.size, HeightMapSource{}.size);
    EXPECT_EQ(read(configuration.expanded["axes"]["heightmap"].dump()).expanded, configuration.expanded);
}

TEST_F(ConfigurationFiles, TakeNoCopyPerHeightMapSize) {
    EXPECT_THAT(ids(read(R"(["there.png", "rock"])", {"heightmap_size=64,128"})),
                ElementsAre("plain | heightmap=there.png", "plain | heightmap=rock heightmap_size=64x64",
                            "plain | heightmap=rock heightmap_size=128x128"));
}

TEST_F(ConfigurationFiles, OfOneBaseNameCannotBeToldApart) {
    EXPECT_THAT(error_message([&] { ids(read(R"(["both.png", "../other/both.png"])")); }),
                AllOf(HasSubstr("configs/both.png"), HasSubstr("other/both.png"), HasSubstr("rename")));
}

TEST_F(ConfigurationFiles, OfAlbedosAreAnAxisAndPartOfTheMapsName) {
    const std::string own = R"({"name": "rock", "albedo": "both.png"})";
    const auto albedo = [&](const std::string& heightmap, const std::vector<std::string>& overrides) {
        return expand(read(heightmap, overrides), fake_techniques()).front().view.height_map.albedo;
    };
    const auto names = [](const std::vector<Cell>& cells) {
        std::vector<std::string> found;
        for (const Cell& cell : cells)
            found.push_back(cell.id);
        return found;
    };
    EXPECT_EQ(albedo(R"("rock")", {"albedo=skin.jpg"}), (root_ / "here/skin.jpg").string());
    EXPECT_EQ(albedo(own, {}), (root_ / "configs/both.png").string());
    EXPECT_EQ(albedo(own, {"albedo=skin.jpg"}), (root_ / "here/skin.jpg").string()) << "what is asked for last";
    EXPECT_EQ(albedo(own, {"albedo=none"}), "");
    for (const auto& both : {std::vector<std::string>{"albedo=none", "heightmap=" + own},
                             std::vector<std::string>{"heightmap=" + own, "albedo=none"}})
        EXPECT_THAT(error_message([&] { read(R"("rock")", both); }), HasSubstr("give either that or the axis albedo"));
    const std::vector<Cell> cells =
        expand(read(R"(["rock", "both.png"])", {"albedo=none,skin.jpg"}), fake_techniques());
    EXPECT_THAT(names(cells), ElementsAre("plain | heightmap=rock", "plain | heightmap=rock+albedo=skin.jpg",
                                          "plain | heightmap=both.png", "plain | heightmap=both.png+albedo=skin.jpg"));
    EXPECT_THAT(names(filter_cells(cells, {"albedo=skin.jpg", "heightmap=rock"}, fake_techniques())),
                ElementsAre("plain | heightmap=rock+albedo=skin.jpg"));
    EXPECT_FALSE(axes_to_json(cells[1].view).contains("albedo"));
    EXPECT_THAT(error_message([&] { read(R"("rock")", {"albedo=gone.png"}); }),
                AllOf(HasSubstr("-a albedo=gone.png"), HasSubstr("no file 'gone.png'")));
}

TEST_F(ConfigurationFiles, OfAPipeAreTakenFromTheWorkingDirectory) {
    const Json json = parse_json(with(R"("axes": {"heightmap": "both.png"})", R"(["plain"])"), "test");
    for (const char* file : {"standard input", "/dev/stdin", "/dev/fd/63", "/proc/self/fd/0"}) {
        const Configuration configuration = parse_configuration(json, file, {}, fake_techniques());
        EXPECT_EQ(source(configuration), (root_ / "here/both.png").string()) << file;
        EXPECT_EQ(configuration.name, "configuration") << file;
    }
}

TEST_F(ConfigurationFiles, WithCommasAndBracketsAreWrittenAsJson) {
    const std::string name = "sp ace, [x]=d|\u00e9<i>.png";
    write_text_file(root_ / "here" / name, "not read");
    const std::string quoted = "[" + Json(name).dump() + "]";
    const Configuration configuration = read(R"("rock")", {"heightmap=" + quoted});
    EXPECT_EQ(source(configuration), (root_ / "here" / name).string());
    const std::vector<Cell> cells = expand(configuration, fake_techniques());
    EXPECT_EQ(filter_cells(cells, {"heightmap=" + quoted}, fake_techniques()).size(), 1U);
    EXPECT_EQ(filter_cells(cells, {"heightmap=rock," + quoted}, fake_techniques()).size(), 1U);
    EXPECT_THAT(error_message([&] { filter_cells(cells, {"heightmap!=" + quoted}, fake_techniques()); }),
                HasSubstr("no cell"));
}

}  // namespace
}  // namespace reliefbench
