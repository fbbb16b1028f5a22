#include "core/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

using namespace reliefbench;

namespace {

std::vector<double> one_to(int last) {
    std::vector<double> values(static_cast<std::size_t>(last));
    std::iota(values.rbegin(), values.rend(), 1.0);  // descending: order must not matter
    return values;
}

TEST(Statistics, MedianIsTheMiddleOrTheMeanOfTheTwoMiddleValues) {
    EXPECT_EQ(median(std::vector{5.0}), 5.0);
    EXPECT_EQ(median(std::vector{9.0, 1.0, 4.0}), 4.0);
    EXPECT_EQ(median(std::vector{9.0, 1.0, 4.0, 5.0}), 4.5);
}

TEST(Statistics, MedianAbsoluteDeviationIsUnscaled) {
    EXPECT_EQ(median_absolute_deviation(std::vector{1.0, 2.0, 3.0, 4.0, 100.0}), 1.0);
    EXPECT_EQ(median_absolute_deviation(std::vector{7.0}), 0.0);
}

TEST(Statistics, QuantilesInterpolateAsType7) {
    // numpy.quantile([1, 2, 4, 8], p)
    const std::vector<double> values{8, 1, 4, 2};
    EXPECT_EQ(quantile(values, 0), 1.0);
    EXPECT_EQ(quantile(values, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantile(values, 0.9), 6.8);
    EXPECT_EQ(quantile(values, 1), 8.0);
}

TEST(Statistics, MedianIntervalIsTheTabulatedOrderStatistics) {
    // The largest k with 2·P(B < k) <= 0.05, from exact integer sums of binomial coefficients.
    const struct {
        int count, low, high;
    } table[] = {{1, 1, 1},  {2, 1, 2},   {5, 1, 5},   {6, 1, 6},    {8, 1, 8},    {9, 2, 8},
                 {10, 2, 9}, {15, 4, 12}, {20, 6, 15}, {30, 10, 21}, {100, 40, 61}};
    for (const auto& [count, low, high] : table) {
        const Interval interval = median_interval(one_to(count));
        EXPECT_EQ(interval.low, low) << count;
        EXPECT_EQ(interval.high, high) << count;
    }
}

TEST(Statistics, MedianIntervalWidensWithConfidence) {
    // Of 15: 2·P(B < 3) = 0.0074, 2·P(B < 4) = 0.0352.
    EXPECT_EQ(median_interval(one_to(15), 0.99).low, 3.0);
    EXPECT_EQ(median_interval(one_to(15), 0.96).low, 4.0);
}

TEST(Statistics, SummaryCountsEveryValue) {
    const Summary summary = summarize(one_to(1001));
    EXPECT_EQ(summary.mean, 501.0);
    EXPECT_DOUBLE_EQ(summary.rms, std::sqrt(1002.0 * 2003.0 / 6.0));
    EXPECT_EQ(summary.p50, 501.0);
    EXPECT_EQ(summary.p95, 951.0);
    EXPECT_EQ(summary.p99, 991.0);
    EXPECT_EQ(summary.max, 1001.0);
}

TEST(Statistics, SummaryAgreesWithQuantile) {
    std::vector<double> values;
    for (int i = 0; i < 777; ++i) {
        values.push_back((i * 7919 % 777) * 0.37 - 40);
    }
    const Summary summary = summarize(values);
    EXPECT_EQ(summary.p50, quantile(values, 0.50));
    EXPECT_EQ(summary.p95, quantile(values, 0.95));
    EXPECT_EQ(summary.p99, quantile(values, 0.99));
    EXPECT_EQ(summary.max, quantile(values, 1));
}

TEST(Statistics, SummaryOfOneValueIsThatValue) {
    const Summary summary = summarize(std::vector{-3.0});
    EXPECT_EQ(summary.mean, -3.0);
    EXPECT_EQ(summary.rms, 3.0);
    EXPECT_EQ(summary.p50, -3.0);
    EXPECT_EQ(summary.p99, -3.0);
    EXPECT_EQ(summary.max, -3.0);
}

}  // namespace
