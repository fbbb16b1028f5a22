#include "advice/answer.hpp"

#include "store/chosen_figures.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::size_t wide = 200;

CellResult answered(const std::string& setting, double view_angle, double ms, double flip, StopReason stop) {
    CellResult cell;
    cell.cell = fmt::format("{} | view_angle={}", setting, view_angle);
    cell.technique = setting.substr(0, setting.find(' '));
    if (const std::size_t at = setting.find("preset="); at != std::string::npos) cell.preset = setting.substr(at + 7);
    cell.axes = {{"view_angle", view_angle}};
    cell.parameters = {{"max_steps", 16}};
    PassTiming draw;
    draw.median_ms = ms;
    draw.ci95_ms = {ms * 0.99, ms * 1.01};
    cell.time["draw"] = draw;
    cell.stop = stop;
    cell.figures.set(chosen_figures::flip, flip);
    cell.figures.set(chosen_figures::quality, 1);
    cell.figures.set(chosen_figures::missed, setting.starts_with("poor") ? 0.03 : 0.0);
    cell.figures.set(chosen_figures::false_hits, 0);
    return cell;
}

CellResult left_out(const std::string& setting, const std::string& reason) {
    CellResult cell;
    cell.cell = setting + " | view_angle=60";
    cell.technique = setting;
    cell.status = CellStatus::skipped;
    cell.reason = reason;
    return cell;
}

std::vector<CellResult> cells_at(const std::vector<double>& angles) {
    std::vector<CellResult> cells;
    for (const double angle : angles) {
        cells.push_back(answered("pom max_steps=16", angle, 1.6, 0.03, StopReason::precise));
        cells.push_back(answered("secant", angle, 2.4, 0.02, StopReason::narrowed));
        cells.push_back(answered("pom preset=engine", angle, 1.9, 0.08, StopReason::narrowed));
        cells.push_back(answered("poor preset=other", angle, 0.9, 0.2, StopReason::time));
    }
    cells.push_back(left_out("cone", "not measured: too slow"));
    cells.push_back(left_out("cone2", "not measured: too slow"));
    return cells;
}

AdviceRequest within(double ms) {
    return {.limits = {{&known_figure(chosen_figures::cost), ms}},
            .rank_by = &known_figure(chosen_figures::flip),
            .asks_for_all_views = true};
}

std::string words_of(const std::vector<CellResult>& cells, const AdviceRequest& request, bool is_time_over = false) {
    return answer_words(advise(cells, request), {cells, 30, is_time_over, {{"engine", "The Engine"}}}, wide);
}

TEST(Answer, SaysWhatToUseAsALineForAConfigurationTheNextStepAndItsPrice) {
    EXPECT_THAT(words_of(cells_at({60}), within(2)),
                AllOf(HasSubstr("here, within 2.00 ms:\n"),
                      HasSubstr("  use pom max_steps=16: 1.60 ms (95 %: 1.58 to 1.62), FLIP, footprint 0.0300\n"),
                      HasSubstr("    {\"technique\":\"pom\",\"parameters\":{\"max_steps\":16}}\n"),
                      HasSubstr("next better: secant: 2.40 ms, FLIP, footprint 0.0200, 50 % more time\n")));
}

TEST(Answer, SaysWhatPresetsGiveAndWhatWouldBeHadForTheirPrice) {
    EXPECT_THAT(words_of(cells_at({60}), within(2)),
                AllOf(HasSubstr("The Engine (pom preset=engine): 1.90 ms, FLIP, footprint 0.0800; for no more pom "
                                "max_steps=16 has 1.60 ms, FLIP, footprint 0.0300\n"),
                      HasSubstr("other (poor preset=other): 0.900 ms, FLIP, footprint 0.200, misses 3.0 % of its hits; "
                                "nothing that was measured is better for no more\n")));
}

TEST(Answer, IsForAllViewsTogetherFirstThenOneByOne) {
    const std::string words = words_of(cells_at({60, 75}), within(2));
    EXPECT_LT(words.find("in all of these views, within"), words.find("at view_angle=60, within"));
    EXPECT_LT(words.find("at view_angle=60, within"), words.find("at view_angle=75, within"));
}

TEST(Answer, WhereNothingKeepsToTheLimitsTheNearestIsSaid) {
    EXPECT_THAT(words_of(cells_at({60}), within(0.5)),
                AllOf(HasSubstr("nothing does that; nearest comes pom max_steps=16: 1.60 ms"), Not(HasSubstr("use "))));
}

TEST(Answer, SaysWhatWasLeftOutAndWhyAndWhetherTheTimeWasOver) {
    EXPECT_THAT(words_of(cells_at({60}), within(2)),
                AllOf(HasSubstr("4 of 30 cells measured, 2 of them in few rounds"),
                      HasSubstr("2 cells: not measured: too slow\n"), Not(HasSubstr("was over"))));
    EXPECT_THAT(
        words_of(cells_at({60}), within(2), true),
        HasSubstr("was over before everything was decided: 1 with fewer rounds than they want, 24 not reached"));
}

TEST(Answer, WithoutAnythingMeasuredThereIsNone) {
    const std::vector<CellResult> cells = {left_out("cone", "the device lacks it")};
    Advice nothing;
    nothing.request = within(2);
    EXPECT_THAT(answer_words(nothing, {cells, 5, true, {}}, wide),
                AllOf(HasSubstr("there is no advice"), HasSubstr("the device lacks it")));
}

TEST(Answer, AsJsonHasTheAdviceAndTheCounts) {
    const std::vector<CellResult> cells = cells_at({60, 75});
    const Json json = answer_json(advise(cells, within(2)), {cells, 30, false, {}});
    EXPECT_EQ(json.at("all_views").at("best").at("selection").at("technique"), "pom");
    EXPECT_EQ(json.at("views").at(0).at("presets").at(0).at("better").at("setting"), "pom max_steps=16");
    EXPECT_EQ(json.at("cells"), Json::parse(R"({"total": 30, "measured": 8, "few_rounds": 4, "cut_off": 2,
                                                "left_out": 2, "failed": 0, "not_reached": 20})"));
}

}  // namespace
}  // namespace reliefbench
