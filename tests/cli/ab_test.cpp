#include "command_line.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// One technique, "mine", whose folder under techniques/ is the new side and under base/ the baseline.
class Ab : public CommandLine {
protected:
    void SetUp() override {
        copy_technique("steep", "mine");
        std::filesystem::create_directory(path("base"));
        std::filesystem::copy(path("techniques/mine"), path("base/mine"));
        Json json = tiny_configuration();
        json["techniques"] = {"mine"};
        configuration_ = write_configuration("tiny.json", json);
    }

    /// A trace function that calls steep's own search so many times, and finds what `layers` layers find.
    void write_trace(const std::string& side, int searches, const std::string& layers) const {
        // No search depends on another one's result, and none can be left out.
        write(side + "/mine/trace.glsl", R"(#include "march.glsl"
Trace trace(ReliefRay ray) {
    float layers = )" + layers + R"(;
    Crossing crossing = find_crossing(ray, layers);
    for (int i = 1; i < )" + std::to_string(searches) +
                                             R"(; ++i) {
        if (find_crossing(ray, layers + float(i)).s_below < -1.0) return miss(0);
    }
    return hit_on_ray(crossing.s_below, crossing.steps);
}
)");
    }

    /// With defaults for what `more` does not say.
    Outcome ab(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"ab", configuration_, "--techniques", path("techniques")};
        const auto add_default = [&](const std::string& option, const std::string& value) {
            const bool said = std::any_of(more.begin(), more.end(),
                                          [&](const std::string& word) { return word.starts_with(option); });
            if (!said) {
                arguments.insert(arguments.end(), {option, value});
            }
        };
        add_default("--baseline", path("base"));
        add_default("--format", "json");
        arguments.insert(arguments.end(), more.begin(), more.end());
        return reliefbench(arguments);
    }

    std::string configuration_;
};

constexpr const char* own_layers = "layer_count(ray)";

TEST_F(Ab, AShaderThatSearchesEightTimesIsSlower) {
    write_trace("techniques", 8, own_layers);
    // The effect is far above a threshold of 20 %; the budget only bounds a machine that stands still.
    const Outcome outcome = ab({"--threshold", "20%", "--budget", "2m"});
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    const Json json = Json::parse(outcome.out);
    ASSERT_EQ(json.at("cells").size(), 1U);
    const Json& cell = json.at("cells")[0];
    EXPECT_EQ(cell.at("verdict"), "slower");
    EXPECT_GT(cell.at("ci95")[0].get<double>(), 1.2);
    EXPECT_EQ(json.at("unit"), "rounds");
    EXPECT_THAT(cell.at("reason").get<std::string>(), HasSubstr("rounds"));
}

TEST_F(Ab, TheOtherWayRoundItIsFasterAndThatIsNoRegression) {
    write_trace("techniques", 1, own_layers);
    write_trace("base", 8, own_layers);
    const Outcome outcome = ab({"--threshold", "20%", "--budget", "2m"});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_EQ(Json::parse(outcome.out).at("cells")[0].at("verdict"), "faster");
}

TEST_F(Ab, IdenticalShadersAreNeverSlowerOrFaster) {
    const Outcome outcome = ab({"--budget", "2s"});
    EXPECT_THAT(outcome.code, testing::AnyOf(0, 3)) << outcome.out;
    const Json cell = Json::parse(outcome.out).at("cells")[0];
    EXPECT_THAT(cell.at("verdict").get<std::string>(), testing::AnyOf("same", "undecided"));
    EXPECT_EQ(cell.at("quality").at("verdict"), "same") << cell;
    EXPECT_THAT(outcome.out, HasSubstr("the sources are the same on both sides: mine"));
    EXPECT_THAT(outcome.err,
                HasSubstr("warning: nothing differs between the sides: the new one has the techniques of"));
}

TEST_F(Ab, TheComparisonAndEveryRawSampleAreKeptWhereAsked) {
    const Outcome outcome = ab({"--budget", "1s", "-o", path("kept/here")});
    EXPECT_EQ(read_file(path("kept/here/comparison.json")), outcome.out);
    const std::vector<Json> visits = read_lines(path("kept/here/pairs.jsonl"));
    const Json cell = Json::parse(outcome.out).at("cells")[0];
    ASSERT_EQ(visits.size(), cell.at("units").get<std::size_t>());
    for (std::size_t round = 0; round < visits.size(); ++round) {
        EXPECT_EQ(visits[round].at("cell"), cell.at("cell"));
        EXPECT_EQ(visits[round].at("round"), round);
        EXPECT_EQ(visits[round].at("base_ms").size(), visits[round].at("new_ms").size());
    }
    EXPECT_EQ(ab({"--budget", "1s", "-o", path("kept/here")}).code, 2) << "earlier samples would be overwritten";
}

TEST_F(Ab, AnErrorThatGrewIsAWorseQuality) {
    write_trace("base", 1, "32");
    write_trace("techniques", 1, "8");
    const Outcome outcome = ab({"--threshold", "99%", "--budget", "1s"});
    EXPECT_EQ(outcome.code, 1) << outcome.out;
    EXPECT_EQ(Json::parse(outcome.out).at("cells")[0].at("quality").at("verdict"), "worse");
    EXPECT_THAT(outcome.out, HasSubstr("error.uv_texels"));
}

TEST_F(Ab, ARefinementPutBackIsBetterThoughSomeNormalsAreFurtherOff) {
    for (const auto& [side, answer] :
         {std::pair("base", "crossing.s_below"), std::pair("techniques", "refine_linearly(ray, crossing).s")}) {
        write(std::string(side) + "/mine/trace.glsl", std::string(R"(#include "march.glsl"
Trace trace(ReliefRay ray) {
    Crossing crossing = find_crossing(ray, layer_count(ray));
    return hit_on_ray()") + answer + R"(, crossing.steps);
}
)");
    }
    const Outcome outcome = ab({"--threshold", "99%", "--budget", "1s", "-a", "heightmap_size=64", "-a",
                                "view_angle=70", "-a", "projection=parallel"});
    EXPECT_NE(outcome.code, 1) << outcome.err;
    const Json quality = Json::parse(outcome.out).at("cells")[0].at("quality");
    EXPECT_EQ(quality.at("verdict"), "better");
    const Json& first = quality.at("changes")[0];
    EXPECT_TRUE(first.at("decides") == true && first.at("better") == true) << first;
    const bool normals_are_worse =
        std::any_of(quality.at("changes").begin(), quality.at("changes").end(), [](const Json& change) {
            return change.at("field").get<std::string>().starts_with("error.normal_deg.") && change.at("worse") == true;
        });
    EXPECT_TRUE(normals_are_worse) << quality;
}

TEST_F(Ab, EachSideIsCompiledWithItsOwnSharedShaders) {
    const std::filesystem::path source = RELIEFBENCH_SOURCE_DIR;
    std::filesystem::create_directories(path("old/harness"));
    std::filesystem::copy(source / "harness/shaders", path("old/harness/shaders"),
                          std::filesystem::copy_options::recursive);
    std::filesystem::create_directory(path("old/techniques"));
    std::filesystem::copy(path("techniques/mine"), path("old/techniques/mine"));
    const std::string shared = "old/harness/shaders/library/march.glsl";
    write(shared, read_file(path(shared)) + "\nthis is no GLSL;\n");
    const Outcome outcome = ab({"--baseline", path("old"), "--budget", "1s"});
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("shared shaders (harness/shaders) differ"), HasSubstr("march.glsl"),
                                   HasSubstr("baseline: failed: technique 'mine'")));
    EXPECT_EQ(outcome.code, 3) << "a baseline that does not compile is no failure of the new side";
}

TEST_F(Ab, AShaderThatNoLongerCompilesFailedNow) {
    write("techniques/mine/trace.glsl", "this is no GLSL;\n");
    const Outcome outcome = ab({"--budget", "1s"});
    EXPECT_EQ(outcome.code, 4) << outcome.out;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("new side"), HasSubstr("trace.glsl")));
}

TEST_F(Ab, WhatTheBaselineDoesNotHaveIsToldAndNotCompared) {
    std::filesystem::rename(path("base/mine"), path("base/other"));
    const Outcome outcome = ab({"--budget", "1s"});
    EXPECT_EQ(outcome.code, 3) << "nothing compared decides nothing: " << outcome.out;
    const Json json = Json::parse(outcome.out);
    EXPECT_THAT(json.at("cells"), IsEmpty());
    EXPECT_THAT(json.at("uncompared")[0].dump(), HasSubstr("the baseline has no such technique"));
}

TEST_F(Ab, ADefaultThatChangedMakesItAnotherCell) {
    Json manifest = Json::parse(read_file(path("techniques/mine/technique.json")));
    for (Json& parameter : manifest["parameters"]) {
        if (parameter.at("name") == "max_steps") parameter["default"] = 30;
    }
    write("techniques/mine/technique.json", manifest.dump());
    Outcome outcome = ab({"--budget", "1s"});
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("a default has changed"), HasSubstr("mine max_steps=30")));
    EXPECT_THAT(Json::parse(outcome.out).at("cells"), IsEmpty());
    // Set by name, it is the same cell on both sides.
    outcome = ab({"--budget", "1s", "-a", "max_steps=20"});
    EXPECT_EQ(Json::parse(outcome.out).at("cells").size(), 1U) << outcome.out;
}

TEST_F(Ab, ANewParameterAtItsDefaultIsNoOtherCell) {
    Json manifest = Json::parse(read_file(path("techniques/mine/technique.json")));
    manifest["parameters"].push_back(
        Json::parse(R"({ "name": "extra", "type": "integer", "default": 0, "range": [0, 9], "help": "h" })"));
    write("techniques/mine/technique.json", manifest.dump());
    EXPECT_EQ(Json::parse(ab({"--budget", "1s"}).out).at("cells").size(), 1U);
    const Outcome set = ab({"--budget", "1s", "-a", "extra=3"});
    EXPECT_THAT(set.out, HasSubstr("no parameter extra, which is 3 here"));
}

/// A copy of a shipped technique, edited or not, needs no other name.
TEST_F(Ab, ACopyOfAShippedTechniqueTakesItsPlace) {
    copy_technique("steep", "steep");
    write("techniques/steep/trace.glsl", read_file(path("techniques/steep/trace.glsl")) + "// edited\n");
    const std::string shipped = std::string(RELIEFBENCH_SOURCE_DIR) + "/techniques";
    const Outcome outcome = ab({"--baseline", shipped, "-a", "technique=steep", "--budget", "1s"});
    ASSERT_THAT(outcome.code, testing::AnyOf(0, 1, 3)) << outcome.err;
    const Json json = Json::parse(outcome.out);
    ASSERT_EQ(json.at("cells").size(), 1U) << json;
    EXPECT_NE(json.at("environment").at("base").at("techniques").at("steep"),
              json.at("environment").at("new").at("techniques").at("steep"));
    EXPECT_THAT(outcome.out, HasSubstr("in place of the shipped ones: " + path("techniques/steep")));
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("the sources are the same on both sides")));
    // Both sides by name.
    std::filesystem::copy(path("techniques/steep"), path("base/steep"));
    const Outcome copies = ab({"-a", "technique=steep", "--budget", "1s"});
    EXPECT_THAT(copies.out, HasSubstr("the sources are the same on both sides: steep"));
}

TEST_F(Ab, BadInputIsRefusedBeforeAnythingIsMeasured) {
    struct Case {
        std::vector<std::string> arguments;
        std::string words;
    };
    const std::vector<Case> cases = {
        {{"--threshold", "0"}, "--threshold"},
        {{"--threshold", "much"}, "--threshold"},
        {{"--budget", "soon"}, "--budget"},
        {{"--budget", "0s"}, "--budget"},
        {{"--baseline", "no-such-revision"}, "neither a folder nor a revision"},
        {{"--baseline=-x"}, "neither a folder nor a revision"},
        {{"--baseline", path("techniques/mine")}, "one technique's folder"},
        {{"--format", "jsn"}, "jsn"},
    };
    for (const Case& bad : cases) {
        const Outcome outcome = ab(bad.arguments);
        EXPECT_EQ(outcome.code, 2) << bad.words;
        EXPECT_THAT(outcome.err, HasSubstr(bad.words));
        EXPECT_THAT(outcome.out, IsEmpty());
    }
    EXPECT_EQ(reliefbench({"ab", configuration_}).code, 2) << "no baseline";
}

}  // namespace
}  // namespace reliefbench
