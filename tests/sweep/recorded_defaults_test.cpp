#include "sweep/recorded_defaults.hpp"

#include "fake_techniques.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::ElementsAre;
using testing::FieldsAre;
using testing::IsEmpty;

Json defaults_of_then(const std::string& parameters, const std::string& axes = "{}") {
    return {{"parameters", Json::parse(parameters)}, {"axes", Json::parse(axes)}};
}

RepeatedConfiguration repeated(const std::string& configuration, const Json& defaults) {
    return with_recorded_defaults(Json::parse(configuration), defaults, fake_techniques());
}

TEST(RecordedDefaults, ThatAreStillTheDefaultsLeaveAConfigurationAlone) {
    const Json configuration = Json::parse(R"({"techniques": [{"technique": "march"}], "axes": {"heightmap": "a"}})");
    const RepeatedConfiguration same = repeated(
        configuration.dump(), defaults_of_then(R"({"march": {"max_steps": 32, "gone": 3}})", R"({"fov": 45})"));
    EXPECT_EQ(same.configuration, configuration);
    EXPECT_THAT(same.changes, IsEmpty());
}

TEST(RecordedDefaults, ThatChangedAreWrittenOutAndReported) {
    const RepeatedConfiguration then =
        repeated(R"({"techniques": [{"technique": "march"}, {"technique": "tree", "parameters": {"leaf": ["exact"]}}],
                     "axes": {"heightmap": "a"}})",
                 defaults_of_then(R"({"march": {"adaptive": true}, "tree": {"leaf": "linear"}})", R"({"fov": 60})"));
    EXPECT_EQ(then.configuration, Json::parse(R"({
        "techniques": [{"technique": "march", "parameters": {"adaptive": true}},
                       {"technique": "tree", "parameters": {"leaf": ["exact"]}}],
        "axes": {"heightmap": "a", "fov": 60}})"));
    EXPECT_THAT(then.changes, ElementsAre(FieldsAre("march", "march: adaptive=true, which is false by default now"),
                                          FieldsAre("", "fov=60, which is 45 by default now")));
    EXPECT_THAT(then.unknown, IsEmpty());
}

TEST(RecordedDefaults, OfWhatAnAxisSetsDoNotCount) {
    const RepeatedConfiguration swept = repeated(
        R"({"techniques": [{"technique": "march"}, {"technique": "tree"}], "axes": {"sample_count": [8], "leaf": ["exact"]}})",
        defaults_of_then(
            R"({"march": {"max_steps": 16, "min_steps": 2}, "tree": {"leaf": "linear", "max_steps": 1}})"));
    EXPECT_THAT(swept.changes, IsEmpty());
}

TEST(RecordedDefaults, OfWhatTheCommandLineSetsDoNotCount) {
    const RepeatedConfiguration set = with_recorded_defaults(
        Json::parse(R"({"techniques": [{"technique": "march"}], "axes": {}})"),
        defaults_of_then(R"({"march": {"adaptive": true}})", R"({"fov": 60})"), fake_techniques(), {"adaptive", "fov"});
    EXPECT_THAT(set.changes, IsEmpty());
}

TEST(RecordedDefaults, ThatNobodyKnowsAreSaidToBe) {
    const RepeatedConfiguration then = repeated(
        R"({"techniques": [{"technique": "march"}, {"technique": "plain"}, {"technique": "tree"}], "axes": {}})",
        defaults_of_then(R"({"tree": {"max_steps": 64}})"));
    EXPECT_THAT(then.unknown, ElementsAre("march")) << "plain has no parameter";
}

TEST(RecordedDefaults, OfAConfigurationThatIsNoneAreLeftToItsReader) {
    for (const char* text : {"3", "{}", R"({"techniques": "march", "axes": {}})", R"({"techniques": [3], "axes": {}})"})
        EXPECT_EQ(repeated(text, defaults_of_then(R"({"march": {"max_steps": 16}})")).configuration, Json::parse(text));
}

}  // namespace
}  // namespace reliefbench
