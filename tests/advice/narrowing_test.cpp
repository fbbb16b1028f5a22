#include "advice/narrowing.hpp"

#include "core/random.hpp"
#include "core/statistics.hpp"
#include "report/quality_cost.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace reliefbench {
namespace {

using testing::Contains;
using testing::HasSubstr;

PassTiming timing(const std::vector<double>& medians) {
    PassTiming draw;
    draw.median_ms = median(medians);
    draw.ci95_ms = median_interval(medians);
    draw.rounds = medians.size();
    return draw;
}

/// A technique whose time grows linearly and whose error falls with its sample count, in views that are more or less
/// hard.
struct FakeTechnique {
    std::string name;
    double fixed_ms = 0.2;
    double ms_per_sample = 0.05;
    double error_of_one = 1;
    double order = 1;
    double least_error = 0.01;
    /// Empty: it has no sample count.
    std::vector<int> counts = {4, 6, 8, 11, 16, 23, 32, 45, 64, 91, 128, 181, 256};
    bool is_wanted = false;
    bool is_skipped = false;
    bool needs_maps = false;
};

/// A sweep without a device: times and errors by formulas, times with noise.
class FakeSweep {
public:
    FakeSweep(const std::vector<FakeTechnique>& techniques, std::size_t angles, std::size_t azimuths,
              double noise = 0.02)
        : noise_(noise) {
        std::size_t ladder = 0;
        for (const FakeTechnique& technique : techniques) {
            for (const int count : technique.counts.empty() ? std::vector<int>{0} : technique.counts) {
                SweptSetting setting{.technique = technique.name,
                                     .ladder = ladder,
                                     .sample_count = count,
                                     .distance_from_start = std::abs(std::log2(std::max(count, 1) / 16.0)),
                                     .needs_maps = technique.needs_maps,
                                     .is_wanted = technique.is_wanted};
                for (std::size_t view = 0; view < angles * azimuths; ++view) {
                    setting.cells.emplace_back(cells_.size());
                    cells_.push_back(cell(technique, count, view / azimuths, view % azimuths));
                }
                settings_.push_back(setting);
            }
            ++ladder;
        }
        Contest all;
        for (std::size_t angle = 0; angle < angles; ++angle) {
            Contest& contest = contests_.emplace_back();
            for (std::size_t azimuth = 0; azimuth < azimuths; ++azimuth) {
                contest.push_back(angle * azimuths + azimuth);
                all.push_back(contest.back());
            }
        }
        if (angles > 1) contests_.push_back(all);
    }

    static AdviceRequest request(double budget_ms, double flip = 0) {
        AdviceRequest request;
        if (budget_ms > 0) request.limits.push_back({&known_figure(chosen_figures::cost), budget_ms});
        if (flip > 0) request.limits.push_back({&known_figure(chosen_figures::flip), flip});
        request.rank_by = &known_figure(chosen_figures::flip);
        return request;
    }

    /// What is measured until nothing more is worth it, at most so many rounds.
    std::vector<CellResult> narrow(const AdviceRequest& request, std::size_t max_rounds = 4000) {
        Narrowing narrowing(settings_, contests_, request);
        std::map<std::size_t, std::vector<double>> medians;
        constexpr std::size_t rounds_of_settled = 12;
        for (std::size_t round = 0; round < max_rounds; ++round) {
            const std::vector<std::size_t> visited = narrowing.next_round();
            if (visited.empty()) break;
            rounds.push_back(visited);
            for (const std::size_t index : visited) {
                const CellResult& cell = cells_[index];
                if (medians[index].empty()) {
                    narrowing.set_result(index, cell);
                    order_drawn.push_back(index);
                    if (cell.status != CellStatus::ok) continue;
                }
                medians[index].push_back(cell.time.at("draw").median_ms * (1 + noise_ * (2 * random_.uniform() - 1)));
                narrowing.set_times(index,
                                    time_bounds(timing(medians[index]), medians[index].size() >= rounds_of_settled));
            }
        }
        std::vector<CellResult> measured;
        for (std::size_t index = 0; index < cells_.size(); ++index) {
            if (medians[index].empty()) {
                reasons[cells_[index].cell] = narrowing.reason_left_out(index);
                continue;
            }
            visits += medians[index].size();
            measured.push_back(cells_[index]);
            measured.back().time["draw"] = timing(medians[index]);
        }
        return measured;
    }

    const std::vector<CellResult>& all() const { return cells_; }
    std::size_t drawn() const { return order_drawn.size(); }

    std::vector<std::vector<std::size_t>> rounds;
    std::vector<std::size_t> order_drawn;
    std::size_t visits = 0;
    std::map<std::string, std::string> reasons;

private:
    static CellResult cell(const FakeTechnique& technique, int count, std::size_t angle, std::size_t azimuth) {
        CellResult cell;
        const double hardness = 1 + 0.6 * static_cast<double>(angle) + 0.1 * static_cast<double>(azimuth);
        cell.technique = technique.name;
        const std::string setting = count == 0 ? technique.name : fmt::format("{} n={}", technique.name, count);
        cell.cell = fmt::format("{} | view_angle={} azimuth={}", setting, 60 + angle, azimuth);
        cell.axes = {{"view_angle", 60 + angle}, {"azimuth", azimuth}};
        if (technique.is_skipped) {
            cell.status = CellStatus::skipped;
            cell.reason = "the device lacks it";
            return cell;
        }
        const double error =
            technique.least_error + technique.error_of_one / std::pow(std::max(count, 1), technique.order);
        PassTiming draw;
        draw.median_ms = technique.fixed_ms + technique.ms_per_sample * count * hardness;
        draw.ci95_ms = {draw.median_ms * 0.999, draw.median_ms * 1.001};
        cell.time["draw"] = draw;
        cell.figures.set(chosen_figures::flip, error * hardness);
        cell.figures.set(chosen_figures::quality, error * 10);
        cell.figures.set(chosen_figures::missed, std::min(0.004, error / 100));
        cell.figures.set(chosen_figures::false_hits, 0.0);
        return cell;
    }

    double noise_;
    Random random_{7};
    std::vector<CellResult> cells_;
    std::vector<SweptSetting> settings_;
    std::vector<Contest> contests_;
};

std::vector<FakeTechnique> usual_techniques() {
    return {{.name = "linear"},
            {.name = "refined", .fixed_ms = 0.4, .ms_per_sample = 0.06, .order = 1.7, .least_error = 0.006},
            {.name = "slow", .fixed_ms = 3, .ms_per_sample = 0.2, .order = 2, .least_error = 0.002},
            {.name = "cone",
             .fixed_ms = 1.1,
             .ms_per_sample = 0.004,
             .error_of_one = 3,
             .order = 1.5,
             .least_error = 0.012},
            {.name = "exact", .fixed_ms = 7, .error_of_one = 0, .least_error = 0.0005, .counts = {}},
            {.name = "flat", .fixed_ms = 0.1, .error_of_one = 0, .least_error = 0.4, .counts = {}}};
}

/// By the rules of an exhaustive sweep, with the true times.
double true_rank(const FakeSweep& sweep, const AdviceRequest& request, const std::string& setting, std::size_t view) {
    double worst = 0;
    const ViewAdvice all = advise(sweep.all(), request).views.at(view);
    for (const CellResult& cell : sweep.all()) {
        const bool is_of_view =
            std::ranges::any_of(all.views, [&](const std::string& id) { return cell.cell == setting + " | " + id; });
        if (is_of_view) worst = std::max(worst, value_of(chosen_figures::flip, cell).value_or(0));
    }
    return worst;
}

TEST(Narrowing, AnswersABudgetAsAnExhaustiveSweepDoesForAFractionOfItsDraws) {
    for (const double budget : {0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 20.0}) {
        FakeSweep sweep(usual_techniques(), 2, 3);
        const AdviceRequest request = FakeSweep::request(budget);
        const Advice exhaustive = advise(sweep.all(), request);
        const Advice narrowed = advise(sweep.narrow(request), request);
        ASSERT_EQ(narrowed.views.size(), 2U);
        for (std::size_t view = 0; view < 2; ++view) {
            ASSERT_TRUE(narrowed.views[view].best) << budget;
            const double least = exhaustive.views[view].best->figures.front().value();
            EXPECT_LE(true_rank(sweep, request, narrowed.views[view].best->setting, view), 1.05 * least + 1e-9)
                << budget << ' ' << narrowed.views[view].best->setting << ' ' << exhaustive.views[view].best->setting;
        }
        EXPECT_LT(sweep.drawn(), sweep.all().size() * 45 / 100) << budget;
    }
}

TEST(Narrowing, AnswersALimitOnAnErrorByItsErrorsFirst) {
    for (const double flip : {0.3, 0.1, 0.05, 0.03, 0.02}) {
        FakeSweep sweep(usual_techniques(), 2, 3);
        const AdviceRequest request = FakeSweep::request(0, flip);
        const Advice exhaustive = advise(sweep.all(), request);
        const Advice narrowed = advise(sweep.narrow(request), request);
        for (std::size_t view = 0; view < 2; ++view) {
            ASSERT_TRUE(narrowed.views[view].best) << flip;
            EXPECT_LE(narrowed.views[view].best->ms, 1.05 * exhaustive.views[view].best->ms)
                << flip << ' ' << narrowed.views[view].best->setting << ' ' << exhaustive.views[view].best->setting;
        }
        EXPECT_LT(sweep.drawn(), sweep.all().size() * 45 / 100) << flip;
    }
}

TEST(Narrowing, FindsTheFirstStepBeyondTheBudget) {
    FakeSweep sweep(usual_techniques(), 1, 2, 0);
    const AdviceRequest request = FakeSweep::request(2);
    const Advice exhaustive = advise(sweep.all(), request);
    const Advice narrowed = advise(sweep.narrow(request), request);
    ASSERT_FALSE(narrowed.views[0].next_better.empty());
    EXPECT_EQ(narrowed.views[0].next_better.front().setting, exhaustive.views[0].next_better.front().setting);
}

TEST(Narrowing, WhereNothingKeepsToTheBudgetTheNearestIsFound) {
    FakeSweep sweep(usual_techniques(), 1, 2, 0);
    const AdviceRequest request = FakeSweep::request(0.05);
    const Advice narrowed = advise(sweep.narrow(request), request);
    EXPECT_FALSE(narrowed.views[0].best);
    ASSERT_TRUE(narrowed.views[0].nearest);
    EXPECT_EQ(narrowed.views[0].nearest->setting, "flat");
}

TEST(Narrowing, WhatIsTooSlowIsNotDrawnWithMoreSamplesAndGetsNoThirdRound) {
    FakeSweep sweep({{.name = "good", .ms_per_sample = 0.01}, {.name = "endless", .fixed_ms = 50, .ms_per_sample = 10}},
                    1, 2);
    sweep.narrow(FakeSweep::request(1));
    std::size_t draws = 0;
    for (const std::size_t cell : sweep.order_drawn) {
        if (sweep.all()[cell].technique == "endless") ++draws;
    }
    // At its least sample count as well: what that takes is not bounded by what more samples take.
    EXPECT_LE(draws, 3U);
    for (const std::vector<std::size_t>& round : sweep.rounds) {
        if (&round - sweep.rounds.data() < 8) continue;
        for (const std::size_t cell : round)
            EXPECT_EQ(sweep.all()[cell].technique, "good");
    }
    EXPECT_THAT(sweep.reasons.at("endless n=256 | view_angle=60 azimuth=0"), HasSubstr("takes longer than the budget"));
}

TEST(Narrowing, ContendersGetRoundsUntilTheyAreSettledAndLosersFew) {
    FakeSweep sweep(usual_techniques(), 1, 1);
    const Advice advice = advise(sweep.narrow(FakeSweep::request(2)), FakeSweep::request(2));
    std::map<std::string, std::size_t> rounds;
    for (const std::vector<std::size_t>& round : sweep.rounds) {
        for (const std::size_t cell : round)
            ++rounds[split_cell_id(sweep.all()[cell].cell).first];
    }
    EXPECT_EQ(rounds.at(advice.views[0].best->setting), 12U);
    EXPECT_LE(rounds.at("flat"), 3U);
}

TEST(Narrowing, WhatIsWantedIsMeasuredInAllViewsWhateverElseIsBetter) {
    std::vector<FakeTechnique> techniques = usual_techniques();
    techniques.push_back({.name = "poor", .fixed_ms = 30, .counts = {}, .is_wanted = true});
    FakeSweep sweep(techniques, 2, 2);
    std::size_t found = 0;
    for (const CellResult& cell : sweep.narrow(FakeSweep::request(2))) {
        if (cell.technique == "poor") ++found;
    }
    EXPECT_EQ(found, 4U);
}

TEST(Narrowing, WhatIsWantedOrNeedsMapsIsLookedAtWhenTheOthersHaveBeen) {
    std::vector<FakeTechnique> techniques = usual_techniques();
    techniques.insert(techniques.begin(), {.name = "preset", .counts = {}, .is_wanted = true});
    techniques.insert(techniques.begin(), {.name = "mapped", .needs_maps = true});
    FakeSweep sweep(techniques, 1, 2);
    sweep.narrow(FakeSweep::request(2));
    const auto place = [&](const std::string& technique, bool last) {
        std::size_t found = sweep.drawn();
        for (std::size_t at = 0; at < sweep.drawn(); ++at) {
            if (sweep.all()[sweep.order_drawn[at]].technique == technique && (last || found == sweep.drawn()))
                found = at;
        }
        return found;
    };
    EXPECT_LT(place("linear", true), place("mapped", false));
    EXPECT_LT(place("mapped", true), place("preset", false));
    EXPECT_LT(place("preset", true), sweep.drawn());
}

TEST(Narrowing, WhatIsSkippedOnceIsNotTriedWithOtherSampleCounts) {
    std::vector<FakeTechnique> techniques = usual_techniques();
    techniques.push_back({.name = "lacking", .is_skipped = true});
    FakeSweep sweep(techniques, 1, 2);
    sweep.narrow(FakeSweep::request(2));
    std::size_t tried = 0;
    for (const std::size_t cell : sweep.order_drawn) {
        if (sweep.all()[cell].technique == "lacking") ++tried;
    }
    EXPECT_EQ(tried, 1U);
    EXPECT_THAT(sweep.reasons.at("lacking n=4 | view_angle=60 azimuth=0"), HasSubstr("the device lacks it"));
}

TEST(Narrowing, EveryCellThatWasNotMeasuredHasAReason) {
    FakeSweep sweep(usual_techniques(), 2, 3);
    sweep.narrow(FakeSweep::request(2));
    for (const auto& [cell, reason] : sweep.reasons)
        EXPECT_THAT(reason, testing::StartsWith("not measured: ")) << cell;
}

TEST(Narrowing, WhatIsLeftOfASweepThatEndedEarlyMayStillBeWorthMeasuring) {
    FakeSweep sweep(usual_techniques(), 1, 2);
    sweep.narrow(FakeSweep::request(2), 1);
    EXPECT_THAT(sweep.reasons, Contains(testing::Pair(HasSubstr("refined"), "")));
}

TEST(TimeBounds, LieOutsideOfWhatFewRoundsHaveSeenAndAreTheMediansIntervalOfMany) {
    const TimeBounds one = time_bounds(timing({2}), false);
    EXPECT_NEAR(one.low_ms, 1.4, 1e-12);
    EXPECT_NEAR(one.high_ms, 2.6, 1e-12);
    const TimeBounds three = time_bounds(timing({2, 3, 1}), false);
    EXPECT_NEAR(three.low_ms, 0.9, 1e-12);
    EXPECT_NEAR(three.high_ms, 3.3, 1e-12);
    EXPECT_DOUBLE_EQ(three.median_ms, 2);
    const TimeBounds many = time_bounds(timing({1, 2, 3, 4, 5, 6}), true);
    EXPECT_DOUBLE_EQ(many.low_ms, 1);
    EXPECT_DOUBLE_EQ(many.high_ms, 6);
    EXPECT_TRUE(many.is_settled);
}

}  // namespace
}  // namespace reliefbench
