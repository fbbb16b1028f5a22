#include "measure/cell_figures.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

TEST(Timing, MedianAndIntervalAreOfTheRounds) {
    const PassTiming timing = summarize_timing({{1, 2}, {3, 9}, {5}}, 4);
    EXPECT_EQ(timing.n, 5U);
    EXPECT_EQ(timing.rounds, 3U);
    // Of 1.5, 6 and 5.
    EXPECT_EQ(timing.median_ms, 5);
    // Of all samples.
    EXPECT_EQ(timing.mad_ms, 2);
    EXPECT_EQ(timing.repeats, 4);
    // Too few rounds for 95 %: the interval is the whole range.
    EXPECT_EQ(timing.ci95_ms.low, 1.5);
    EXPECT_EQ(timing.ci95_ms.high, 6);
}

TEST(Timing, OutliersAreCountedAndKept) {
    const PassTiming timing = summarize_timing({{1, 1.5, 2}, {1.25, 1.75, 100}}, 1);
    EXPECT_EQ(timing.outliers, 1U);
    EXPECT_EQ(timing.n, 6U);
}

TEST(Timing, PreparationIsTheSumOfItsPassesMedians) {
    Preparation preparation;
    preparation.pass_ms = {{"base", {1, 2, 9}}, {"levels", {0.5, 0.25, 4}}};
    EXPECT_EQ(preparation_ms(preparation), 2.5);
    EXPECT_EQ(preparation_ms({}), 0);
}

}  // namespace
}  // namespace reliefbench
