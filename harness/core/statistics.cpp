#include "core/statistics.hpp"

#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace reliefbench {

namespace {

/// The p-quantile of `values`, whose elements before `begin` are known to be no larger than the rest. Reorders the
/// rest; on return the same holds for the rank in `begin`, so that ascending quantiles cost less and less.
double take_quantile(std::vector<double>& values, double p, std::size_t& begin) {
    const double rank = p * static_cast<double>(values.size() - 1);
    const auto lower = static_cast<std::size_t>(rank);
    const double fraction = rank - static_cast<double>(lower);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(lower);
    std::nth_element(values.begin() + static_cast<std::ptrdiff_t>(begin), at, values.end());
    begin = lower;
    if (fraction == 0) return *at;
    const double upper = *std::min_element(at + 1, values.end());
    return std::lerp(*at, upper, fraction);
}

}  // namespace

double quantile(std::span<const double> values, double p) {
    assert(!values.empty() && p >= 0 && p <= 1);
    std::vector<double> copy(values.begin(), values.end());
    std::size_t begin = 0;
    return take_quantile(copy, p, begin);
}

double median(std::span<const double> values) {
    return quantile(values, 0.5);
}

double median_absolute_deviation(std::span<const double> values) {
    const double centre = median(values);
    std::vector<double> deviations(values.size());
    std::transform(values.begin(), values.end(), deviations.begin(),
                   [centre](double value) { return std::abs(value - centre); });
    return median(deviations);
}

Interval median_interval(std::span<const double> values, double confidence) {
    assert(!values.empty() && confidence > 0 && confidence < 1);
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    // The k-th values from both ends miss the median with probability 2·P(B < k), B ~ binomial(n, 1/2).
    const boost::math::binomial below_median(static_cast<double>(sorted.size()), 0.5);
    std::size_t from_end = 0;
    while (2 * from_end + 2 < sorted.size() &&
           2 * boost::math::cdf(below_median, static_cast<double>(from_end + 1)) <= 1 - confidence) {
        ++from_end;
    }
    return {sorted[from_end], sorted[sorted.size() - 1 - from_end]};
}

Summary summarize(std::span<const double> values) {
    assert(!values.empty());
    double sum = 0;
    double sum_of_squares = 0;
    for (const double value : values) {
        sum += value;
        sum_of_squares += value * value;
    }
    const auto count = static_cast<double>(values.size());
    Summary summary;
    summary.mean = sum / count;
    summary.rms = std::sqrt(sum_of_squares / count);
    std::vector<double> copy(values.begin(), values.end());
    std::size_t begin = 0;
    summary.p50 = take_quantile(copy, 0.50, begin);
    summary.p95 = take_quantile(copy, 0.95, begin);
    summary.p99 = take_quantile(copy, 0.99, begin);
    summary.max = *std::max_element(copy.begin() + static_cast<std::ptrdiff_t>(begin), copy.end());
    return summary;
}

}  // namespace reliefbench
