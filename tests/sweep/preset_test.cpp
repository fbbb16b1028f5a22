#include "core/error.hpp"
#include "fake_techniques.hpp"
#include "support/error_message.hpp"
#include "sweep/configuration.hpp"
#include "sweep/recorded_defaults.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::FieldsAre;
using testing::HasSubstr;

Configuration configuration_of(const std::string& techniques, const std::string& more_axes = "",
                               const std::vector<std::string>& overrides = {}) {
    const std::string text =
        R"({"techniques": [)" + techniques + R"(], "axes": {"heightmap": "bricks")" + more_axes + "}}";
    return parse_configuration(parse_json(text, "test.json"), "test.json", overrides, fake_techniques());
}

std::vector<Cell> cells_of(const std::string& techniques, const std::string& more_axes = "",
                           const std::vector<std::string>& overrides = {}) {
    return expand(configuration_of(techniques, more_axes, overrides), fake_techniques());
}

/// Without the view, which is the same in all.
std::vector<std::string> settings_of(const std::vector<Cell>& cells) {
    std::vector<std::string> settings;
    for (const Cell& cell : cells)
        settings.push_back(cell.id.substr(0, cell.id.find(" | ")));
    return settings;
}

std::string complaint(const std::string& techniques, const std::vector<std::string>& overrides = {}) {
    return error_message([&] { cells_of(techniques, "", overrides); });
}

TEST(Presets, TakeThePlaceOfTheDefaultsAndNameTheirCells) {
    const std::vector<Cell> cells =
        cells_of(R"("march", {"technique": "march", "preset": ["quick_engine", "slow_engine"]})");
    EXPECT_THAT(settings_of(cells), ElementsAre("march", "march preset=quick_engine", "march preset=slow_engine"));
    EXPECT_EQ(cells[0].preset, "");
    EXPECT_EQ(cells[1].preset, "quick_engine");
    EXPECT_EQ(cells[1].parameters,
              (ParameterValues{{"max_steps", std::int64_t{16}}, {"min_steps", std::int64_t{8}}, {"adaptive", true}}));
    EXPECT_EQ(cells[2].parameters,
              (ParameterValues{{"max_steps", std::int64_t{128}}, {"min_steps", std::int64_t{8}}, {"adaptive", false}}));
}

TEST(Presets, LoseToWhateverElseSetsAParameterAndTheNameShowsIt) {
    EXPECT_THAT(settings_of(cells_of(
                    R"({"technique": "march", "preset": "quick_engine", "parameters": {"max_steps": [16, 32]}})")),
                ElementsAre("march preset=quick_engine", "march preset=quick_engine max_steps=32"));
    EXPECT_THAT(settings_of(cells_of(R"({"technique": "march", "preset": "quick_engine"})", R"(, "adaptive": false)")),
                ElementsAre("march preset=quick_engine adaptive=false"));
    EXPECT_THAT(settings_of(cells_of(R"({"technique": "march", "preset": "quick_engine"})", "", {"min_steps=4"})),
                ElementsAre("march preset=quick_engine min_steps=4"));
}

TEST(Presets, KeepTheirOwnRatioOfStepsWhenTheSampleCountIsSwept) {
    const std::vector<Cell> cells =
        cells_of(R"({"technique": "march", "preset": "quick_engine"})", R"(, "sample_count": [16, 64])");
    EXPECT_THAT(settings_of(cells),
                ElementsAre("march preset=quick_engine", "march preset=quick_engine max_steps=64 min_steps=32"));
}

TEST(Presets, AreChosenOnTheCommandLineForTheTechniquesThatHaveThem) {
    EXPECT_THAT(settings_of(cells_of(R"("plain", {"technique": "march", "preset": "slow_engine"}, "tree")", "",
                                     {"preset=quick_engine,forest"})),
                ElementsAre("plain", "march preset=quick_engine", "tree preset=forest"));
}

TEST(Presets, ThatAreUnknownOrAnothersAreErrors) {
    EXPECT_THAT(complaint(R"({"technique": "march", "preset": "quick_engin"})"),
                AllOf(HasSubstr("test.json: $.techniques[0].preset: unknown preset 'quick_engin'"),
                      HasSubstr("did you mean 'quick_engine'?")));
    EXPECT_THAT(complaint(R"({"technique": "march", "preset": ["forest"]})"),
                HasSubstr("$.techniques[0].preset[0]: 'forest' is a preset of the technique tree, not of march"));
    EXPECT_THAT(complaint(R"("march")", {"preset=forest"}), HasSubstr("'forest' is a preset of the technique tree"));
    EXPECT_THAT(complaint(R"("march")", {"preset=nothing"}), HasSubstr("unknown preset 'nothing'"));
    EXPECT_THAT(complaint(R"({"technique": "march", "preset": []})"), HasSubstr("at least one value"));
    EXPECT_THAT(error_message([] { cells_of(R"("march")", R"(, "preset": "quick_engine")"); }),
                HasSubstr("$.axes.preset: presets are named beside their technique"));
}

TEST(Presets, AreReadBackFromTheExpandedConfiguration) {
    const Configuration first =
        configuration_of(R"({"technique": "march", "preset": ["slow_engine"], "parameters": {"min_steps": 4}})");
    const Configuration again = parse_configuration(first.expanded, "again.json", {}, fake_techniques());
    EXPECT_EQ(again.expanded, first.expanded);
    EXPECT_THAT(settings_of(expand(again, fake_techniques())), ElementsAre("march preset=slow_engine min_steps=4"));
}

TEST(Presets, AreFilteredAndExcludedByName) {
    const std::vector<Manifest> techniques = fake_techniques();
    const auto all = [] {
        return cells_of(R"("march", {"technique": "march", "preset": ["quick_engine", "slow_engine"]})");
    };
    EXPECT_THAT(settings_of(filter_cells(all(), {"preset=slow_engine"}, techniques)),
                ElementsAre("march preset=slow_engine"));
    EXPECT_THAT(settings_of(filter_cells(all(), {"preset!=slow_engine"}, techniques)),
                ElementsAre("march", "march preset=quick_engine"));
    const std::string excluded = R"({"techniques": [{"technique": "march", "preset": ["quick_engine", "slow_engine"]}],
        "axes": {"heightmap": "bricks"}, "exclude": [{"preset": "quick_engine"}]})";
    EXPECT_THAT(settings_of(expand(parse_configuration(parse_json(excluded, "test.json"), "test.json", {}, techniques),
                                   techniques)),
                ElementsAre("march preset=slow_engine"));
    EXPECT_THAT(error_message([&] { filter_cells(all(), {"preset=slow"}, techniques); }),
                HasSubstr("unknown preset 'slow'"));
}

TEST(Presets, ThatChangedSinceARunAreRepeatedAsTheyWere) {
    const Json defaults = {
        {"parameters", Json::parse(R"({"march": {"max_steps": 32, "min_steps": 8, "adaptive": false}})")},
        {"axes", Json::object()},
        {"presets", Json::parse(R"({"march": {"quick_engine": {"parameters": {"max_steps": 24, "adaptive": true}},
                                              "slow_engine": {"parameters": {"max_steps": 128}}}})")}};
    const RepeatedConfiguration then = with_recorded_defaults(
        Json::parse(
            R"({"techniques": [{"technique": "march", "preset": ["quick_engine", "slow_engine"]}], "axes": {}})"),
        defaults, fake_techniques());
    EXPECT_EQ(then.configuration.at("techniques"),
              Json::parse(R"([{"technique": "march", "preset": "quick_engine", "parameters": {"max_steps": 24}},
                              {"technique": "march", "preset": "slow_engine"}])"));
    EXPECT_THAT(then.changes,
                ElementsAre(FieldsAre("march", "march: max_steps=24, which is 16 in the preset quick_engine now")));
}

}  // namespace
}  // namespace reliefbench
