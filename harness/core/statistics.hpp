#pragma once

#include <cstddef>
#include <span>

namespace reliefbench {

/// All functions take finite values, in any order, at least one unless said otherwise.

struct Interval {
    double low = 0;
    double high = 0;
};

double median(std::span<const double> values);

/// Median absolute deviation from the median, unscaled.
double median_absolute_deviation(std::span<const double> values);

/// The p-quantile, p in [0, 1], interpolated linearly between order statistics (type 7 of Hyndman & Fan 1996).
double quantile(std::span<const double> values, double p);

/// Order-statistic confidence interval of the median (binomial(n, 1/2)), at least `confidence`, no distribution
/// assumed. With too few values for that (fewer than six at 95 %) the whole range.
Interval median_interval(std::span<const double> values, double confidence = 0.95);

struct Summary {
    double mean = 0;
    double rms = 0;
    double p50 = 0;
    double p95 = 0;
    double p99 = 0;
    double max = 0;
};

/// From all values, not from a histogram. The sum is taken in index order, so that it does not depend on scheduling.
Summary summarize(std::span<const double> values);

}  // namespace reliefbench
