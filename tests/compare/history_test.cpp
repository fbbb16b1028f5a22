#include "compare/history.hpp"

#include "compare/optimal_segments.hpp"
#include "compare/synthetic_runs.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace reliefbench;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

using Series = std::function<double(Random&, std::size_t)>;

std::vector<double> series(Random& random, std::size_t count, const Series& value) {
    std::vector<double> values;
    for (std::size_t index = 0; index < count; ++index) {
        values.push_back(value(random, index));
    }
    return values;
}

/// How many of `trials` series have a change point at all.
int with_changes(const Series& value, std::size_t count, int trials) {
    Random random(4);
    int found = 0;
    for (int trial = 0; trial < trials; ++trial) {
        found += !find_change_points(series(random, count, value), 0.02, 0.01).empty();
    }
    return found;
}

void slow_down(std::vector<StoredRun>& runs, std::size_t from, std::size_t first_cell, std::size_t cells,
               double factor) {
    for (std::size_t run = from; run < runs.size(); ++run) {
        for (std::size_t cell = first_cell; cell < first_cell + cells; ++cell) {
            runs[run].run.cells[cell].time["draw"].median_ms *= factor;
        }
    }
}

TEST(OptimalSegments, FindsTheStepsOfACleanSeries) {
    EXPECT_THAT(optimal_segments(std::vector<double>{1, 1, 1, 2, 2, 2, 2, 1, 1, 1}, 3), ElementsAre(0, 3, 7));
    EXPECT_THAT(optimal_segments(std::vector<double>{1, 1, 1, 1}, 3), ElementsAre(0));
    EXPECT_THAT(optimal_segments(std::vector<double>{1, 2}, 3), ElementsAre(0));
    EXPECT_TRUE(optimal_segments({}, 3).empty());
}

TEST(ChangePoints, AStepIsFoundWhereItIsWithItsRatio) {
    const std::vector<double> logs = {0, 0.01, -0.01, 0.005, 0.30, 0.31, 0.29, 0.305};
    const std::vector<ChangePoint> changes = find_change_points(logs, 0.02, 0.01);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_EQ(changes[0].run, 4U);
    EXPECT_EQ(changes[0].previous, 3U);
    EXPECT_DOUBLE_EQ(changes[0].ratio, std::exp(0.3025 - 0.0025));
    // scipy.stats.ttest_ind of both halves, times 3 places.
    EXPECT_NEAR(changes[0].p / 1.3375817106940025e-08, 1, 1e-6);
}

TEST(ChangePoints, ThreeRunsASideAreEnoughForAClearStep) {
    const std::vector<double> logs = {0, 0.002, -0.001, 0.1, 0.101, 0.099};
    EXPECT_EQ(find_change_points(logs, 0.02, 0.01).size(), 1U);
    EXPECT_TRUE(find_change_points(std::span(logs).first(5), 0.02, 0.01).empty());
}

TEST(ChangePoints, ThereAndBackAreTwo) {
    Random random(9);
    const auto value = [](Random& source, std::size_t run) {
        return (run >= 10 && run < 20 ? std::log(1.15) : 0) + 0.02 * standard_normal(source);
    };
    const std::vector<ChangePoint> changes = find_change_points(series(random, 30, value), 0.02, 0.01);
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0].run, 10U);
    EXPECT_EQ(changes[1].run, 20U);
    EXPECT_GT(changes[0].ratio, 1.1);
    EXPECT_LT(changes[1].ratio, 0.9);
}

TEST(ChangePoints, StepsBelowTheMinimumEffectDoNotMatter) {
    const std::vector<double> logs = {0, 1e-4, -1e-4, 0, 0.01, 0.0101, 0.0099, 0.01};
    EXPECT_TRUE(find_change_points(logs, 0.02, 0.01).empty());
    EXPECT_EQ(find_change_points(logs, 0.005, 0.01).size(), 1U);
}

TEST(ChangePoints, EmptyShortAndConstantSeriesHaveNone) {
    EXPECT_TRUE(find_change_points({}, 0.02, 0.01).empty());
    EXPECT_TRUE(find_change_points(std::vector<double>{1}, 0.02, 0.01).empty());
    EXPECT_TRUE(find_change_points(std::vector<double>(50, 0.5), 0.02, 0.01).empty());
}

TEST(ChangePoints, NoiseOfAnyShapeHasAlmostNone) {
    constexpr int trials = 200;
    const Series normal = [](Random& random, std::size_t) { return 0.05 * standard_normal(random); };
    const Series skewed = [](Random& random, std::size_t) { return 0.05 * std::exp(standard_normal(random)); };
    const Series bimodal = [](Random& random, std::size_t) {
        return (random.below(2) == 0 ? 0.2 : 0) + 0.01 * standard_normal(random);
    };
    const Series outliers = [](Random& random, std::size_t) {
        return random.below(20) == 0 ? 1.0 : 0.03 * standard_normal(random);
    };
    const Series tied = [](Random& random, std::size_t) { return 0.05 * static_cast<double>(random.below(3)); };
    for (const Series& noise : {normal, skewed, bimodal, outliers, tied}) {
        for (const std::size_t count : {6, 10, 20, 50}) {
            // At a limit of 1 in 100; two expected of 200, and more than 8 in less than 1 of 1000 tries.
            EXPECT_LE(with_changes(noise, count, trials), 8) << count;
        }
    }
}

TEST(ChangePoints, OneOutlierAtTheEndIsNoChange) {
    const Series noise = [](Random& random, std::size_t run) {
        return run == 49 ? 1.0 : 0.03 * standard_normal(random);
    };
    // No more than the limit of 1 in 100 lets through without it; more than 5 in less than 1 of 1000 tries.
    EXPECT_LE(with_changes(noise, 50, 100), 5);
}

TEST(History, AStepOfFifteenPerCentIsFoundInTenAndTenRuns) {
    Random random(6);
    RunsModel model;
    model.smallest_sd = model.largest_sd = 0.05;
    std::vector<StoredRun> runs = synthetic_runs(model, 20, random);
    slow_down(runs, 10, 0, 40, 1.15);
    const History history = make_history(runs, {});
    std::size_t found = 0;
    std::size_t false_alarms = 0;
    for (std::size_t cell = 0; cell < history.cells.size(); ++cell) {
        const bool changed = !history.cells[cell].changes.empty();
        (cell < 40 ? found : false_alarms) += changed;
    }
    EXPECT_GE(found, 38U);
    EXPECT_LE(false_alarms, 1U);
    ASSERT_FALSE(history.groups.empty());
    const auto largest = std::max_element(
        history.groups.begin(), history.groups.end(),
        [](const MovedTogether& a, const MovedTogether& b) { return a.cells.size() < b.cells.size(); });
    EXPECT_EQ(largest->run, 10U);
    EXPECT_TRUE(largest->slower);
    EXPECT_GE(largest->cells.size(), 30U);
}

TEST(History, RunsOfIdenticalCodeHaveAlmostNoChangePoints) {
    Random random(8);
    std::size_t changes = 0;
    for (int trial = 0; trial < 5; ++trial) {
        const History history = make_history(synthetic_runs({}, 20, random), {});
        for (const CellHistory& cell : history.cells) {
            changes += cell.changes.size();
        }
    }
    EXPECT_LE(changes, 1U);  // of 375 series
}

TEST(History, CellsThatMoveTogetherAreAGroup) {
    Random random(3);
    RunsModel model;
    model.cells = 20;
    model.smallest_sd = model.largest_sd = model.common_sd = 0.002;
    std::vector<StoredRun> runs = synthetic_runs(model, 16, random);
    slow_down(runs, 7, 0, 6, 1.21);
    slow_down(runs, 7, 6, 6, 1.34);
    slow_down(runs, 11, 12, 1, 0.5);
    const History history = make_history(runs, {});
    ASSERT_EQ(history.groups.size(), 2U);
    EXPECT_EQ(history.groups[0].cells.size(), 12U);
    EXPECT_EQ(history.groups[0].text, "between run 7 and 8: 12 cells slower, 1.21 to 1.34 times");
    EXPECT_EQ(history.groups[1].text, "between run 11 and 12: 1 cell faster, 0.50 times");
    EXPECT_THAT(history.groups[1].cells, ElementsAre(12));
    EXPECT_EQ(history.runs.front(), "run1");
}

TEST(History, RunsThatLackACellLeaveAGap) {
    std::vector<StoredRun> runs;
    for (int run = 0; run < 8; ++run) {
        const double ms = (run < 4 ? 1 : 2) * (1 + 0.001 * (run % 3));
        runs.push_back(one_run(fmt::format("r{}", run), {cell_result("c", ms)}));
    }
    runs[3].run.cells.clear();
    // Another subject under the same id is no part of the series.
    runs[0].run.cells[0].parameters["max_steps"] = 8;
    const History history = make_history(runs, {});
    ASSERT_EQ(history.cells.size(), 1U);
    const CellHistory& cell = history.cells[0];
    EXPECT_FALSE(cell.median_ms[0].has_value());
    EXPECT_TRUE(cell.median_ms[1].has_value());
    EXPECT_FALSE(cell.median_ms[3].has_value());
    // Two values before the step are too few: a run more makes it.
    EXPECT_TRUE(cell.changes.empty());
    runs.insert(runs.begin() + 1, one_run("more", {cell_result("c", 1)}));
    const History longer = make_history(runs, {});
    ASSERT_EQ(longer.cells[0].changes.size(), 1U);
    EXPECT_EQ(longer.cells[0].changes[0].previous, 3U);
    EXPECT_EQ(longer.cells[0].changes[0].run, 5U);
    EXPECT_EQ(longer.groups[0].text, "between run 4 and 6: 1 cell slower, 2.00 times");
}

TEST(History, TellsWhatChangedInTheRecords) {
    std::vector<StoredRun> runs(3, one_run("r", {}));
    runs[2].run.run["device"]["driver_version"] = "1.3";
    const History history = make_history(runs, {});
    ASSERT_EQ(history.record_changes.size(), 1U);
    EXPECT_EQ(history.record_changes[0].run, 2U);
    EXPECT_THAT(history.record_changes[0].differences, ElementsAre("the driver's version changed from 1.2 to 1.3"));
    runs[1].name = "odd";
    runs[1].run.run["device"]["name"] = "another device";
    EXPECT_THAT(error_message([&] { make_history(runs, {}); }), HasSubstr("leave odd out"));
}

}  // namespace
