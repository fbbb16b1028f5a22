#include "compare/optimal_segments.hpp"

#include "core/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>

namespace reliefbench {

namespace {

/// The median of |X - Y| for independent normal X, Y of standard deviation 1.
constexpr double median_absolute_difference = 0.9539;

/// In standard deviations and times log n. What passes is tested; what does not is lost: lower than BIC.
constexpr double penalty_factor = 1.5;

/// Robust against steps and outliers, which make few large differences. 0 for a series of mostly equal values.
double noise_of(std::span<const double> series) {
    std::vector<double> differences;
    for (std::size_t index = 1; index < series.size(); ++index) {
        differences.push_back(std::abs(series[index] - series[index - 1]));
    }
    return median(differences) / median_absolute_difference;
}

/// The sum of absolute deviations from the median of values that come one by one: both halves and their sums.
class AbsoluteDeviations {
public:
    void add(double value) {
        if (lower_.empty() || value <= *lower_.rbegin()) {
            lower_.insert(value);
            lower_sum_ += value;
        } else {
            upper_.insert(value);
            upper_sum_ += value;
        }
        if (lower_.size() > upper_.size() + 1) {
            const auto largest = std::prev(lower_.end());
            move(lower_, largest, lower_sum_, upper_, upper_sum_);
        } else if (upper_.size() > lower_.size()) {
            move(upper_, upper_.begin(), upper_sum_, lower_, lower_sum_);
        }
    }

    double sum() const {
        const double middle = *lower_.rbegin();
        const auto more_below = static_cast<double>(lower_.size()) - static_cast<double>(upper_.size());
        return std::max(0.0, upper_sum_ - lower_sum_ + middle * more_below);
    }

private:
    static void move(std::multiset<double>& from, std::multiset<double>::iterator value, double& from_sum,
                     std::multiset<double>& to, double& to_sum) {
        from_sum -= *value;
        to_sum += *value;
        to.insert(from.extract(value));
    }

    std::multiset<double> lower_;
    std::multiset<double> upper_;
    double lower_sum_ = 0;
    double upper_sum_ = 0;
};

}  // namespace

std::vector<std::size_t> optimal_segments(std::span<const double> series, std::size_t shortest_segment) {
    assert(shortest_segment > 0);
    const std::size_t size = series.size();
    if (size == 0) return {};
    if (size < 2 * shortest_segment) return {0};
    const double penalty = penalty_factor * noise_of(series) * std::log(static_cast<double>(size));

    // best[begin]: the least cost of the series from `begin` on, found from its end.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> best(size + 1, infinity);
    std::vector<std::size_t> next(size + 1, size);
    best[size] = 0;
    for (std::size_t begin = size; begin-- > 0;) {
        AbsoluteDeviations deviations;
        for (std::size_t end = begin + 1; end <= size; ++end) {
            deviations.add(series[end - 1]);
            if (end - begin < shortest_segment || best[end] == infinity) continue;
            const double cost = deviations.sum() + penalty + best[end];
            // Of equal costs the longest segment.
            if (cost <= best[begin]) {
                best[begin] = cost;
                next[begin] = end;
            }
        }
    }
    std::vector<std::size_t> starts;
    for (std::size_t begin = 0; begin < size; begin = next[begin]) {
        starts.push_back(begin);
    }
    return starts;
}

}  // namespace reliefbench
