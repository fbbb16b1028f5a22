#include "measure/outliers.hpp"

#include "core/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

constexpr double largest_score = 3.5;
// What makes each deviation one of a normal distribution's standard deviations.
constexpr double median_deviation_factor = 1.4826;
constexpr double mean_deviation_factor = 1.2533;

double mean_absolute_deviation(std::span<const double> values, double centre) {
    double sum = 0;
    for (const double value : values) {
        sum += std::abs(value - centre);
    }
    return sum / static_cast<double>(values.size());
}

}  // namespace

std::size_t count_outliers(std::span<const double> values) {
    if (values.empty()) return 0;
    const double centre = median(values);
    double deviation = median_deviation_factor * median_absolute_deviation(values);
    if (deviation == 0) deviation = mean_deviation_factor * mean_absolute_deviation(values, centre);
    return static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [&](double value) {
        return std::abs(value - centre) > largest_score * deviation;
    }));
}

}  // namespace reliefbench
