#include "compare/paired_rounds.hpp"

#include "compare/look_schedule.hpp"
#include "compare/signed_rank.hpp"
#include "compare/verdict.hpp"
#include "compare/walsh_averages.hpp"
#include "core/random.hpp"
#include "support/normal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace reliefbench;

namespace {

const std::vector<double> twelve = {0.031, 0.052,  -0.013, 0.044, 0.078, 0.020,
                                    0.061, -0.027, 0.039,  0.055, 0.012, 0.090};

std::vector<double> series(std::size_t count, const std::function<double(std::size_t)>& value) {
    std::vector<double> values;
    for (std::size_t index = 0; index < count; ++index) {
        values.push_back(value(index));
    }
    return values;
}

// P-values and order statistics of this fixture are SciPy's (scipy.stats.wilcoxon, mode "exact").
TEST(SignedRank, ExactPValuesAreThoseOfTheTables) {
    EXPECT_EQ(signed_rank_p_above(twelve), 0.00341796875);
    EXPECT_EQ(signed_rank_p_above(series(10, [](std::size_t index) { return 1.0 + static_cast<double>(index); })),
              std::ldexp(1.0, -10));
}

TEST(SignedRank, TiesAndZerosKeepTheTestExact) {
    // By enumerating all 2^7 signs: the sum of positive mean ranks is 21.5.
    EXPECT_EQ(signed_rank_p_above(std::vector<double>{1, 1, 2, -2, 3, 0, -1, 4}), 0.1328125);
    EXPECT_EQ(signed_rank_p_above(std::vector<double>{0, 0, 0}), 1);
}

TEST(SignedRank, ManyValuesTakeTheNormalDistributionWithTheVarianceOfTies) {
    const auto value = [](std::size_t index) { return std::floor((static_cast<double>(index * 37 % 101) - 45) / 7); };
    // SciPy's differs in that it subtracts the continuity towards the mean on either side: the same above it.
    EXPECT_NEAR(signed_rank_p_above(series(200, value)), 0.1634264503483533, 1e-12);
}

TEST(SignedRank, CentreAndIntervalAreOrderStatisticsOfTheWalshAverages) {
    const ShiftEstimate shift = signed_rank_shift(twelve, 0.05);
    EXPECT_DOUBLE_EQ(shift.centre, 0.038);
    EXPECT_DOUBLE_EQ(shift.interval->low, 0.013);
    EXPECT_DOUBLE_EQ(shift.interval->high, 0.0605);
    const ShiftEstimate stricter = signed_rank_shift(twelve, 0.025);
    EXPECT_DOUBLE_EQ(stricter.interval->low, 0.009);
    EXPECT_DOUBLE_EQ(stricter.interval->high, 0.0645);
}

TEST(SignedRank, FiveValuesGiveNoIntervalAndSixTheirRange) {
    const std::vector<double> values = {5, 1, 4, 2, 3, 9};
    EXPECT_FALSE(signed_rank_shift(std::span(values).first(5), 0.05).interval.has_value());
    const ShiftEstimate shift = signed_rank_shift(values, 0.05);
    EXPECT_EQ(shift.interval->low, 1);
    EXPECT_EQ(shift.interval->high, 9);
}

TEST(WalshAverages, EveryOrderStatisticIsThatOfTheSortedAverages) {
    Random random(3);
    for (const std::size_t size : {1, 2, 3, 7, 20}) {
        for (const bool tied : {false, true}) {
            const std::vector<double> values = series(
                size, [&](std::size_t) { return tied ? static_cast<double>(random.below(3)) : random.uniform(-1, 1); });
            std::vector<double> all;
            for (std::size_t first = 0; first < size; ++first) {
                for (std::size_t second = first; second < size; ++second) {
                    all.push_back((values[first] + values[second]) / 2);
                }
            }
            std::sort(all.begin(), all.end());
            const WalshAverages averages(values);
            ASSERT_EQ(averages.count(), all.size());
            for (std::size_t index = 0; index < all.size(); ++index) {
                EXPECT_EQ(averages.nth(index), all[index]);
            }
        }
    }
}

TEST(WalshAverages, ThousandsOfValuesAreNotTooMany) {
    // 0 ... n-1: the median of all averages is their centre.
    const WalshAverages averages(series(20001, [](std::size_t index) { return static_cast<double>(index); }));
    EXPECT_EQ(averages.nth(averages.count() / 2), 10000);
    EXPECT_EQ(averages.nth(0), 0);
    EXPECT_EQ(averages.nth(averages.count() - 1), 20000);
}

TEST(LookSchedule, LooksDoubleAndSpendTheWholeLevelTogether) {
    EXPECT_FALSE(is_look(8));
    EXPECT_TRUE(is_look(16));
    EXPECT_FALSE(is_look(17));
    EXPECT_TRUE(is_look(64));
    EXPECT_EQ(next_look(0), 16U);
    EXPECT_EQ(next_look(15), 16U);
    EXPECT_EQ(next_look(16), 32U);
    EXPECT_EQ(next_look(40), 64U);
    EXPECT_EQ(level_of_look(3), 0.025);
    EXPECT_EQ(level_of_look(31), 0.025);
    EXPECT_DOUBLE_EQ(level_of_look(32), 0.05 / 6);
    EXPECT_DOUBLE_EQ(level_of_look(100), 0.05 / 12);
    double spent = 0;
    for (std::size_t look = 16; look < (std::size_t{1} << 40); look *= 2) {
        spent += level_of_look(look);
    }
    EXPECT_LT(spent, 0.05);
    EXPECT_GT(spent, 0.048);
}

TEST(PairedRounds, PValuesAreMultipliedByWhatOtherLooksSpend) {
    const RatioEstimate at_once = estimate_paired(twelve, 0.0);
    const RatioEstimate at_a_look = estimate_paired(twelve, 0.0, 0.025);
    EXPECT_DOUBLE_EQ(at_a_look.p_slower, 2 * at_once.p_slower);
    EXPECT_DOUBLE_EQ(at_a_look.ci95.low, std::exp(0.009));
    EXPECT_DOUBLE_EQ(at_once.ci95.low, std::exp(0.013));
    EXPECT_DOUBLE_EQ(at_once.p_slower, 0.00341796875);
}

TEST(PairedRounds, TheThresholdMovesBothTests) {
    const RatioEstimate estimate = estimate_paired(twelve, 0.02);
    EXPECT_DOUBLE_EQ(estimate.p_slower, 0.064697265625);
    EXPECT_DOUBLE_EQ(estimate.p_faster, 0.99951171875);
    EXPECT_DOUBLE_EQ(estimate.ratio, std::exp(0.038));
    EXPECT_EQ(estimate.units, 12U);
    ASSERT_TRUE(estimate.more.has_value());
    EXPECT_GT(*estimate.more, 12U);
}

TEST(PairedRounds, TooFewRoundsTellNothing) {
    for (const std::size_t count : {0, 1, 2, 5}) {
        const RatioEstimate estimate = estimate_paired(std::vector<double>(count, 0.0), 0.01);
        EXPECT_EQ(estimate.ci95.low, 0);
        EXPECT_TRUE(std::isinf(estimate.ci95.high));
        EXPECT_EQ(estimate.p_slower, 1);
        EXPECT_TRUE(std::isinf(estimate.visible));
        EXPECT_EQ(decide(std::span(&estimate, 1), 0.01, 0.01).front(), Verdict::undecided);
    }
}

TEST(PairedRounds, EqualTimesAreTheSame) {
    const RatioEstimate estimate = estimate_paired(std::vector<double>(16, 0.0), 0.01, level_of_look(16));
    EXPECT_EQ(estimate.ratio, 1);
    EXPECT_EQ(estimate.more, 0U);
    EXPECT_NEAR(estimate.visible, 0.01, 1e-15);  // log1p and expm1 round
    EXPECT_EQ(decide(std::span(&estimate, 1), 0.01, 0.01).front(), Verdict::same);
}

/// How many of 200 cells with the given rounds are called slower and faster at 1 %.
struct Counts {
    int slower = 0;
    int faster = 0;
    int undecided = 0;
};

Counts verdicts_of_cells(const std::function<double(Random&, std::size_t round)>& log_ratio, std::size_t rounds) {
    constexpr int cells = 200;
    Random random(11);
    std::vector<RatioEstimate> estimates;
    for (int cell = 0; cell < cells; ++cell) {
        const std::vector<double> values = series(rounds, [&](std::size_t round) { return log_ratio(random, round); });
        estimates.push_back(estimate_paired(values, 0.01, level_of_look(rounds)));
    }
    Counts counts;
    for (const Verdict verdict : decide(estimates, 0.01, 0.01)) {
        counts.slower += verdict == Verdict::slower;
        counts.faster += verdict == Verdict::faster;
        counts.undecided += verdict == Verdict::undecided;
    }
    return counts;
}

/// One round of identical code: which side came first is a coin, so that whatever the pair's noise is, its sign is
/// fair.
double fair(Random& random, double noise) {
    return random.below(2) == 0 ? noise : -noise;
}

TEST(PairedRounds, IdenticalCodeIsNeverCalledDifferentWhateverTheNoise) {
    const auto normal = [](Random& random, std::size_t) { return 0.19 * standard_normal(random); };
    const auto skewed = [](Random& random, std::size_t) {
        return fair(random, 0.2 * std::exp(standard_normal(random)));
    };
    const auto outliers = [](Random& random, std::size_t) {
        return fair(random, random.below(10) == 0 ? 2 : 0.02 * standard_normal(random));
    };
    const auto bimodal = [](Random& random, std::size_t) {
        return fair(random, random.below(2) == 0 ? 0.3 : 0.01 * standard_normal(random));
    };
    const auto drifting = [](Random& random, std::size_t round) {
        return fair(random, 0.002 * static_cast<double>(round) + 0.02 * standard_normal(random));
    };
    const auto tied = [](Random& random, std::size_t) { return 0.05 * (static_cast<double>(random.below(3)) - 1); };
    for (const auto& noise :
         std::vector<std::function<double(Random&, std::size_t)>>{normal, skewed, outliers, bimodal, drifting, tied}) {
        const Counts counts = verdicts_of_cells(noise, 128);
        EXPECT_EQ(counts.slower, 0);
        EXPECT_EQ(counts.faster, 0);
    }
}

TEST(PairedRounds, FivePerCentAreFoundInNinetyFivePerCentOfCellsWithOutliersAmongTheRounds) {
    const auto slower = [](Random& random, std::size_t) {
        return std::log(1.05) + (random.below(10) == 0 ? fair(random, 1) : 0.10 * standard_normal(random));
    };
    const Counts counts = verdicts_of_cells(slower, 512);
    EXPECT_GE(counts.slower, 190);
    EXPECT_EQ(counts.faster, 0);
}

TEST(PairedRounds, WhatIsVisibleIsSeen) {
    // A change as large as `visible` says, at the level of these verdicts.
    Random random(5);
    int seen = 0;
    constexpr int trials = 300;
    for (int trial = 0; trial < trials; ++trial) {
        const std::vector<double> noise = series(256, [&](std::size_t) { return 0.1 * standard_normal(random); });
        const double visible = estimate_paired(noise, 0.01, level_of_look(256)).visible;
        const std::vector<double> changed =
            series(256, [&](std::size_t) { return std::log1p(visible) + 0.1 * standard_normal(random); });
        const RatioEstimate estimate = estimate_paired(changed, 0.01, level_of_look(256));
        seen += decide(std::span(&estimate, 1), 0.01, 0.01).front() == Verdict::slower;
    }
    // 99 in 100 as a rule: 297 of 300 expected; fewer than 290 has a probability below 1 in 1000.
    EXPECT_GE(seen, 290);
}

}  // namespace
