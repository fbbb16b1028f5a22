#include "report/engine_answers.hpp"

#include "support/cell_figures.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// `setting` with a preset as ids have it: "pom preset=x".
CellResult drawn(const std::string& setting, double ms, double flip, double wrong = 0, double half_interval = 0.01) {
    CellResult cell;
    cell.cell = setting + " | heightmap=bricks";
    cell.technique = setting.substr(0, setting.find(' '));
    if (const std::size_t at = setting.find("preset="); at != std::string::npos) {
        const std::string rest = setting.substr(at + 7);
        cell.preset = rest.substr(0, rest.find(' '));
    }
    cell.axes = {{"heightmap", "bricks"}, {"resolution", "200x100"}};
    PassTiming draw;
    draw.median_ms = ms;
    draw.ci95_ms = {ms * (1 - half_interval), ms * (1 + half_interval)};
    cell.time["draw"] = draw;
    set_figures(cell, {{"work.covered_pixels", 5000},
                       {"error.uv_texels.p99", 10 * flip},
                       {"error.missed", wrong},
                       {"error.false_hits", 0},
                       {"image.flip", 0.5},
                       {"image.footprint.flip", flip},
                       {"image.footprint.psnr", 30},
                       {"image.footprint.ssim", 0.9},
                       {"image.footprint.rmse", 0.1}});
    return cell;
}

Json record() {
    return Json::parse(R"({"presets": {"pom": {
        "quick": {"title": "Quick Engine", "source": "quick", "parameters": {}, "not_expressed": "Its dithering."},
        "slow": {"title": "Slow Engine", "source": "slow", "parameters": {}, "not_expressed": ""}}}})");
}

std::vector<PresetAdvice> presets_of(const std::vector<CellResult>& cells) {
    const std::optional<Advice> advice = answer_engines(cells, record());
    return advice ? advice->views.front().presets : std::vector<PresetAdvice>();
}

std::string name(const std::optional<AdvisedSetting>& setting) {
    return setting ? setting->setting : "";
}

TEST(EngineAnswers, SayWhatIsBetterForNoMoreTimeAndWhatIsAsGoodForLess) {
    const std::vector<PresetAdvice> presets =
        presets_of({drawn("pom preset=slow", 4, 0.05), drawn("pom preset=quick", 2, 0.2), drawn("steep", 1, 0.19),
                    drawn("pom max_steps=16", 1.9, 0.1), drawn("qdm", 4.1, 0.001), drawn("relief", 3, 0.051)});
    ASSERT_EQ(presets.size(), 2U);
    EXPECT_EQ(presets[0].preset.setting, "pom preset=quick") << "in the order of their times";
    EXPECT_EQ(name(presets[0].better), "pom max_steps=16");
    EXPECT_EQ(name(presets[0].cheaper), "steep");
    EXPECT_EQ(presets[1].preset.preset, "slow");
    EXPECT_EQ(name(presets[1].better), "") << "qdm takes more time, and the others' errors are greater or the same";
    EXPECT_EQ(name(presets[1].cheaper), "relief") << "0.051 cannot be told from 0.05";
}

TEST(EngineAnswers, AdviseNothingThatMissesItsHitsNorAnotherPresetNorWhatIsNotFaster) {
    const std::vector<PresetAdvice> presets =
        presets_of({drawn("pom preset=slow", 4, 0.05), drawn("pom preset=quick", 2, 0.01),
                    drawn("steep", 1, 0.001, 0.006), drawn("relief", 3.97, 0.05)});
    ASSERT_EQ(presets.size(), 2U);
    EXPECT_EQ(name(presets[1].better), "");
    EXPECT_EQ(name(presets[1].cheaper), "") << "the intervals of their times overlap";
}

TEST(EngineAnswers, TakeWhatTheIntervalsOfTimesDoNotTellToBeSlower) {
    const auto presets = [](double ms) {
        return presets_of({drawn("pom preset=slow", 4, 0.05), drawn("qdm", ms, 0.01)});
    };
    EXPECT_EQ(name(presets(4.07).at(0).better), "qdm") << "4.03 to 4.11 and 3.96 to 4.04 overlap";
    EXPECT_EQ(name(presets(4.07).at(0).cheaper), "");
    EXPECT_EQ(name(presets(4.1).at(0).better), "");
    const auto noisy = [](double ms) {
        return presets_of({drawn("pom preset=slow", 4, 0.05, 0, 0.2), drawn("qdm", ms, 0.01, 0, 0.2)});
    };
    EXPECT_EQ(name(noisy(4.19).at(0).better), "qdm");
    EXPECT_EQ(name(noisy(4.21).at(0).better), "") << "5 % longer is too much, whatever the noise";
}

TEST(EngineAnswers, ReplacePresetsThatMissTheirHitsByWhatMissesNoMore) {
    const std::vector<PresetAdvice> presets =
        presets_of({drawn("pom preset=quick", 2, 0.2, 0.02), drawn("steep", 1.9, 0.01, 0.021),
                    drawn("relief", 2, 0.1, 0.02), drawn("secant", 1.5, 0.2, 0.01), drawn("qdm", 1.2, 0.1, 0.03)});
    ASSERT_EQ(presets.size(), 1U);
    EXPECT_EQ(name(presets[0].better), "relief");
    EXPECT_EQ(name(presets[0].cheaper), "secant");
}

TEST(EngineAnswers, ReplacePresetsThatMissTheirHitsFirstByWhatFindsThem) {
    const std::vector<PresetAdvice> presets =
        presets_of({drawn("pom preset=quick", 2, 0.2, 0.02), drawn("steep", 1.9, 0.01, 0.02),
                    drawn("relief", 1.8, 0.1, 0.005), drawn("secant", 1.5, 0.1, 0.01)});
    ASSERT_EQ(presets.size(), 1U);
    EXPECT_EQ(name(presets[0].better), "relief");
    EXPECT_EQ(name(presets[0].cheaper), "relief");
}

TEST(EngineAnswers, OfPresetsThatMissTheirHitsAreGivenAllTheSame) {
    const std::vector<PresetAdvice> presets =
        presets_of({drawn("pom preset=slow", 4, 0.05, 0.03), drawn("qdm", 3, 0.01)});
    ASSERT_EQ(presets.size(), 1U);
    EXPECT_EQ(presets[0].preset.wrong_hits, 0.03);
    EXPECT_EQ(name(presets[0].better), "qdm");
}

TEST(EngineAnswers, AreNoneWhereNoPresetWasMeasured) {
    CellResult failed = drawn("pom preset=slow", 4, 0.05);
    failed.status = CellStatus::failed;
    EXPECT_FALSE(answer_engines({drawn("pom", 1, 0.1), failed}, record()));
    EXPECT_FALSE(answer_engines({}, record()));
}

TEST(EngineAnswers, NameEnginesAndWhatTheirPresetsLeaveOut) {
    const std::vector<CellResult> cells{drawn("pom preset=quick", 2, 0.2), drawn("pom preset=slow", 4, 0.05),
                                        drawn("qdm", 1, 0.001)};
    const std::string text = format_engines(*answer_engines(cells, record()), record(), 160);
    EXPECT_THAT(text, AllOf(HasSubstr("Quick Engine"), HasSubstr("better, no slower"), HasSubstr("qdm"),
                            HasSubstr("Quick Engine: Its dithering."), Not(HasSubstr("Slow Engine: "))));
    EXPECT_THAT(text, Not(HasSubstr("as good, faster  "))) << "it is the same setting";
}

}  // namespace
}  // namespace reliefbench
