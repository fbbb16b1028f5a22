#include "compare/between_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace reliefbench;

namespace {

// Expected values were computed with SciPy 1.10 (scipy.stats.t); they are held to what it printed, but for rounding.
constexpr double relative = 1e-9;

void expect_near(double value, double expected) {
    EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

const std::vector<double> base = {1.0, 1.1, 0.95, 1.05, 0.98};
const std::vector<double> slower = {1.3, 1.42, 1.25, 1.36, 1.29};
const RunNoise no_noise{0, 0, ""};
const RunNoise tenth{0.1, 23, ""};

TEST(BetweenRuns, WithoutNoiseIsTheTTestOnLogarithms) {
    const RatioEstimate estimate = estimate_between_runs(base, slower, no_noise, 0.02);
    expect_near(estimate.ratio, 1.3036101481330638);
    expect_near(estimate.ci95.low, 1.2047693481732917);
    expect_near(estimate.ci95.high, 1.4105599722404871);
    expect_near(estimate.p_slower, 4.7370312520291244e-05);
    expect_near(estimate.p_faster, 0.9999837432595752);
    expect_near(estimate.visible, 0.3380576189270058);
    expect_near(estimate.p_unchanged, 5.463182291343942e-05);
    EXPECT_EQ(estimate.units, 5U);
    EXPECT_EQ(estimate.more, 0U);
}

TEST(BetweenRuns, NoiseCountsByItsDegreesOfFreedom) {
    const RatioEstimate estimate = estimate_between_runs(base, slower, tenth, 0.02);
    expect_near(estimate.ci95.low, 1.160115638435097);
    expect_near(estimate.ci95.high, 1.464853469786738);
    expect_near(estimate.p_slower, 8.094212359726099e-05);
    expect_near(estimate.visible, 0.4445694667425083);
    expect_near(estimate.p_unchanged, 6.063670161226518e-05);
}

TEST(BetweenRuns, OneRunASideRestsOnTheNoiseAlone) {
    const RatioEstimate estimate = estimate_between_runs(std::vector{1.0}, std::vector{1.2}, tenth, 0.02);
    expect_near(estimate.ratio, 1.2);
    expect_near(estimate.ci95.low, 0.8956273934155277);
    expect_near(estimate.ci95.high, 1.6078114744888221);
    expect_near(estimate.p_slower, 0.13114571571489853);
    expect_near(estimate.visible, 1.4748011872090243);
    expect_near(estimate.p_unchanged, 0.21014118758952038);
    EXPECT_EQ(estimate.more, 9U);
}

TEST(BetweenRuns, SidesMayHaveDifferentNumbersOfRuns) {
    const RatioEstimate estimate =
        estimate_between_runs(std::vector{1.0, 1.1}, std::vector{1.02, 1.05, 1.2}, tenth, 0.02);
    expect_near(estimate.ratio, 1.0366382506350378);
    expect_near(estimate.ci95.high, 1.2458574907419349);
    expect_near(estimate.visible, 0.773569116919753);
    expect_near(estimate.p_unchanged, 0.6907321538902726);
    EXPECT_EQ(estimate.units, 2U);
    EXPECT_EQ(estimate.more, 795U);
}

TEST(BetweenRuns, NoReasonableNumberOfRunsDecidesARatioAtTheThreshold) {
    std::vector<double> changed = base;
    for (std::size_t run = 0; run < changed.size(); ++run) {
        changed[run] = changed[run] * 1.015 + 0.001 * static_cast<double>(run);
    }
    EXPECT_EQ(estimate_between_runs(base, changed, no_noise, 0.02).more, std::nullopt);
}

TEST(BetweenRuns, SwappedSidesMirrorTheEstimate) {
    const RatioEstimate there = estimate_between_runs(base, slower, tenth, 0.02);
    const RatioEstimate back = estimate_between_runs(slower, base, tenth, 0.02);
    expect_near(back.ratio, 1 / there.ratio);
    expect_near(back.ci95.low, 1 / there.ci95.high);
    expect_near(back.p_faster, there.p_slower);
    expect_near(back.visible, there.visible);
}

TEST(BetweenRuns, ConstantTimesAreKnownExactly) {
    const std::vector<double> constant(4, 2.5);
    const RatioEstimate same = estimate_between_runs(constant, constant, no_noise, 0.02);
    EXPECT_EQ(same.ci95.low, 1);
    EXPECT_EQ(same.ci95.high, 1);
    EXPECT_EQ(same.p_slower, 1);
    EXPECT_EQ(same.more, 0U);
    const RatioEstimate changed = estimate_between_runs(constant, std::vector<double>(4, 3.0), no_noise, 0.02);
    EXPECT_EQ(changed.p_slower, 0);
    EXPECT_EQ(changed.p_faster, 1);
    expect_near(changed.visible, 0.02);
}

TEST(BetweenRuns, OneOutlierWidensTheIntervalAndDecidesNothing) {
    std::vector<double> changed = base;
    changed.back() *= 5;
    const RatioEstimate estimate = estimate_between_runs(base, changed, no_noise, 0.02);
    EXPECT_LT(estimate.ci95.low, 1);
    EXPECT_GT(estimate.ci95.high, 1.5);
    EXPECT_GT(estimate.p_slower, 0.1);
}

TEST(BetweenRuns, AStricterLevelSeesLess) {
    const RatioEstimate usual = estimate_between_runs(base, slower, tenth, 0.02);
    const RatioEstimate strict = estimate_between_runs(base, slower, tenth, 0.02, 0.01 / 75);
    EXPECT_GT(strict.visible, usual.visible);
    EXPECT_EQ(strict.p_slower, usual.p_slower);
    EXPECT_EQ(usual.more, 0U);
    EXPECT_EQ(strict.more, 1U);
}

TEST(BetweenRuns, InflationWidensAllAndMovesNothing) {
    const RatioEstimate usual = estimate_between_runs(base, slower, no_noise, 0.02);
    const RatioEstimate inflated = estimate_between_runs(base, slower, no_noise, 0.02, highest_p_unchanged, 3);
    EXPECT_EQ(inflated.ratio, usual.ratio);
    expect_near(std::log(inflated.ci95.high / inflated.ci95.low), 3 * std::log(usual.ci95.high / usual.ci95.low));
    EXPECT_GT(inflated.p_slower, usual.p_slower);
    EXPECT_GT(inflated.visible, usual.visible);
}

std::vector<ControlCell> controls(std::size_t count, double log_ratio) {
    std::vector<ControlCell> cells(count);
    for (ControlCell& cell : cells) {
        // Half width 2.306 standard errors of 0.1 for 8 degrees of freedom.
        cell.estimate.ratio = std::exp(log_ratio);
        cell.estimate.ci95 = {std::exp(log_ratio - 0.23060041350333704), std::exp(log_ratio + 0.23060041350333704)};
        cell.degrees_of_freedom = 8;
    }
    return cells;
}

TEST(NoiseInflation, IsTheMedianDistanceInQuartilesOfT) {
    // scipy.stats.t.ppf(0.75, 8) is 0.7063866.
    EXPECT_NEAR(noise_inflation(controls(10, 0.4)), 4 / 0.7063866, 1e-6);
    EXPECT_NEAR(noise_inflation(controls(11, -0.4)), 4 / 0.7063866, 1e-6);
}

TEST(NoiseInflation, IsNeverBelowOneAndNeedsTenCells) {
    EXPECT_EQ(noise_inflation(controls(20, 0.01)), 1);
    EXPECT_EQ(noise_inflation(controls(9, 0.4)), 1);
    EXPECT_EQ(noise_inflation({}), 1);
}

}  // namespace
