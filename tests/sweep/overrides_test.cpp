#include "configuration_text.hpp"
#include "sweep/override_effects.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

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

TEST(Overrides, OfTechniquesKeepTheParametersOfThoseSelectedBefore) {
    const std::string text = with(R"("axes": {"heightmap": "rock"})",
                                  R"(["plain", {"technique": "tree", "parameters": {"leaf": "linear"}}])");
    EXPECT_THAT(ids(parse(text, {"technique=tree,mesh"})),
                ElementsAre("tree leaf=linear | heightmap=rock", "mesh | heightmap=rock"));
    EXPECT_THAT(message_of(text, {"technique=tre"}), HasSubstr("-a technique=tre: technique: unknown technique 'tre'"));
}

}  // namespace
}  // namespace reliefbench
