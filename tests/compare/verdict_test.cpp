#include "compare/verdict.hpp"

#include "compare/describe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace reliefbench;

namespace {

RatioEstimate estimate_of(double ratio, Interval interval, double p_slower, double p_faster = 1) {
    RatioEstimate estimate;
    estimate.ratio = ratio;
    estimate.ci95 = interval;
    estimate.p_slower = p_slower;
    estimate.p_faster = p_faster;
    estimate.p_unchanged = std::min(p_slower, p_faster);
    estimate.visible = 0.12;
    estimate.units = 5;
    estimate.more = 9;
    return estimate;
}

RatioEstimate slower_at(double p) {
    return estimate_of(1.2, {1.1, 1.3}, p);
}

TEST(Decide, SameNeedsTheIntervalInsideTheThreshold) {
    const std::vector<RatioEstimate> estimates = {estimate_of(1, {0.99, 1.01}, 1), estimate_of(1, {0.99, 1.021}, 1),
                                                  estimate_of(1, {0.979, 1.01}, 1), estimate_of(1, {0.981, 1.019}, 1),
                                                  estimate_of(1, {1, 1.02}, 1)};
    // The other end of the threshold is 1 / 1.02, and an interval that reaches it is not inside.
    EXPECT_EQ(decide(estimates, 0.02, 0.01),
              (std::vector{Verdict::same, Verdict::undecided, Verdict::undecided, Verdict::same, Verdict::undecided}));
}

TEST(Decide, SlowerAndFasterNeedBothThePValueAndTheInterval) {
    const std::vector<RatioEstimate> estimates = {
        estimate_of(1.2, {1.1, 1.3}, 1e-6), estimate_of(0.8, {0.7, 0.9}, 1, 1e-6), estimate_of(1.2, {1.01, 1.3}, 1e-6),
        estimate_of(1.2, {1.1, 1.3}, 0.2)};
    EXPECT_EQ(decide(estimates, 0.02, 0.01),
              (std::vector{Verdict::slower, Verdict::faster, Verdict::undecided, Verdict::undecided}));
}

TEST(Decide, BenjaminiHochbergCountsBothDirectionsAndAllCells) {
    // Two-sided p 1e-4, 2e-4, 3e-4, 6e-4 of four cells at 4e-4: the limits are 1e-4, 2e-4, 3e-4, 4e-4.
    const std::vector<RatioEstimate> estimates = {slower_at(1.5e-4), slower_at(5e-5), slower_at(3e-4), slower_at(1e-4)};
    EXPECT_EQ(decide(estimates, 0.02, 4e-4),
              (std::vector{Verdict::slower, Verdict::slower, Verdict::undecided, Verdict::slower}));
    // The third limit is missed: with it go those that its rank would have carried.
    const std::vector<RatioEstimate> weaker = {slower_at(1.6e-4), slower_at(5e-5), slower_at(3e-4), slower_at(1.4e-4)};
    EXPECT_EQ(decide(weaker, 0.02, 4e-4),
              (std::vector{Verdict::undecided, Verdict::slower, Verdict::undecided, Verdict::undecided}));
}

TEST(Decide, AStepUpCarriesThoseBelowIt) {
    // 1.9e-4 misses its own limit of 1e-4, but the last passes at rank 4.
    const std::vector<RatioEstimate> estimates(4, slower_at(0.95e-4));
    EXPECT_EQ(decide(estimates, 0.02, 4e-4), std::vector<Verdict>(4, Verdict::slower));
}

TEST(Decide, NoVerdictStandsWhereUnchangedCodeIsLikelyHoweverManyCellsAgree) {
    std::vector<RatioEstimate> agreeing(100, slower_at(1e-6));
    for (RatioEstimate& estimate : agreeing)
        estimate.p_unchanged = 1.1 * highest_p_unchanged;
    EXPECT_EQ(decide(agreeing, 0.02, 0.01), std::vector<Verdict>(100, Verdict::undecided));
    for (RatioEstimate& estimate : agreeing)
        estimate.p_unchanged = highest_p_unchanged;
    EXPECT_EQ(decide(agreeing, 0.02, 0.01), std::vector<Verdict>(100, Verdict::slower));
}

TEST(Decide, NoCellsGiveNoVerdicts) {
    EXPECT_TRUE(decide({}, 0.02, 0.01).empty());
}

TEST(LevelOfVerdicts, IsWhatOneMoreCellWouldHaveHadToPass) {
    std::vector<Verdict> verdicts(100, Verdict::undecided);
    EXPECT_DOUBLE_EQ(level_of_verdicts(verdicts, 0.01), 1e-4);
    verdicts[7] = Verdict::slower;
    verdicts[8] = Verdict::faster;
    verdicts[9] = Verdict::same;
    EXPECT_DOUBLE_EQ(level_of_verdicts(verdicts, 0.01), 3e-4);
    EXPECT_DOUBLE_EQ(level_of_verdicts(std::vector<Verdict>(100, Verdict::slower), 0.01), 0.01);
    EXPECT_DOUBLE_EQ(level_of_verdicts({}, 0.01), 0.01);
}

TEST(IsSettled, DoesNotWaitForOtherCells) {
    EXPECT_TRUE(is_settled(estimate_of(1, {0.99, 1.01}, 1), 0.02, 1e-4));
    EXPECT_TRUE(is_settled(slower_at(0.5e-4), 0.02, 1e-4));
    EXPECT_FALSE(is_settled(slower_at(0.6e-4), 0.02, 1e-4));
    EXPECT_FALSE(is_settled(estimate_of(1, {0.9, 1.1}, 1), 0.02, 1e-4));
}

TEST(Describe, SaysWhyAndWhatWouldDecide) {
    EXPECT_EQ(describe(estimate_of(1.072, {1.051, 1.094}, 0), Verdict::slower, "runs"),
              "slower by 7.2 % (95 %: 5.1 to 9.4 %), 5 runs a side");
    EXPECT_EQ(describe(estimate_of(0.935, {0.918, 0.959}, 0), Verdict::faster, "rounds"),
              "faster by 6.5 % (95 %: 4.1 to 8.2 %), 5 rounds");
    EXPECT_EQ(describe(estimate_of(1.003, {0.992, 1.014}, 0), Verdict::same, "runs"),
              "same: +0.3 % (\u22120.8 to +1.4 %), 5 runs a side");
    EXPECT_EQ(
        describe(estimate_of(1.03, {0.96, 1.11}, 0), Verdict::undecided, "runs"),
        "undecided: +3.0 % (\u22124.0 to +11 %), 5 runs a side; changes above 12 % would have been seen; about 9 more "
        "runs a side would decide");
}

TEST(Describe, SaysWhenNothingWouldDecideOrNothingIsKnown) {
    RatioEstimate estimate = estimate_of(1.02, {0.96, 1.11}, 0);
    estimate.more = std::nullopt;
    EXPECT_THAT(describe(estimate, Verdict::undecided, "rounds"), testing::HasSubstr("no reasonable number of rounds"));
    estimate.more = 1;
    estimate.units = 1;
    EXPECT_THAT(describe(estimate, Verdict::undecided, "runs"),
                testing::AllOf(testing::HasSubstr("1 run a side;"),
                               testing::HasSubstr("about 1 more run a side would decide")));
    estimate.units = 3;
    estimate.ci95 = {0, std::numeric_limits<double>::infinity()};
    EXPECT_EQ(describe(estimate, Verdict::undecided, "rounds"), "undecided: 3 rounds tell nothing yet");
}

}  // namespace
