#include "compare/signed_rank.hpp"

#include "compare/walsh_averages.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace reliefbench {

namespace {

constexpr std::size_t max_values_for_exact = 50;

/// P(T = s) for the sum T of those `ranks` whose sign is positive, signs being fair coins. Ranks are doubled, so that
/// mean ranks are whole.
std::vector<double> distribution_of_rank_sum(const std::vector<std::size_t>& doubled_ranks) {
    std::size_t total = 0;
    for (const std::size_t rank : doubled_ranks) {
        total += rank;
    }
    std::vector<double> probability(total + 1, 0.0);
    probability[0] = 1;
    std::size_t reached = 0;
    for (const std::size_t rank : doubled_ranks) {
        reached += rank;
        for (std::size_t sum = reached + 1; sum-- > 0;) {
            probability[sum] = (probability[sum] + (sum >= rank ? probability[sum - rank] : 0)) / 2;
        }
    }
    return probability;
}

/// Twice the rank that tied values from the `first` to the `last` share, counted from 0.
std::size_t doubled_mean_rank(std::size_t first, std::size_t last) {
    return first + last + 2;
}

struct SignedRanks {
    std::vector<std::size_t> doubled;
    std::size_t doubled_sum_of_positive = 0;
    /// Sum of t³ - t over groups of t tied values.
    double ties = 0;
};

SignedRanks rank(std::span<const double> values) {
    std::vector<double> sorted;
    for (const double value : values) {
        if (value != 0) sorted.push_back(value);
    }
    std::sort(sorted.begin(), sorted.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    SignedRanks ranks;
    for (std::size_t first = 0; first < sorted.size();) {
        std::size_t last = first;
        while (last + 1 < sorted.size() && std::abs(sorted[last + 1]) == std::abs(sorted[first])) {
            ++last;
        }
        const std::size_t doubled = doubled_mean_rank(first, last);
        for (std::size_t index = first; index <= last; ++index) {
            ranks.doubled.push_back(doubled);
            if (sorted[index] > 0) ranks.doubled_sum_of_positive += doubled;
        }
        const auto tied = static_cast<double>(last - first + 1);
        ranks.ties += tied * (tied * tied - 1);
        first = last + 1;
    }
    return ranks;
}

double variance_of_rank_sum(double count, double ties) {
    return count * (count + 1) * (2 * count + 1) / 24 - ties / 48;
}

/// How many Walsh averages lie outside at either end of the interval; empty when leaving out none is too many.
std::optional<std::size_t> left_out_at_each_end(std::size_t count, double level) {
    if (count <= max_values_for_exact) {
        std::vector<std::size_t> doubled;
        for (std::size_t index = 0; index < count; ++index) {
            doubled.push_back(doubled_mean_rank(index, index));
        }
        const std::vector<double> probability = distribution_of_rank_sum(doubled);
        double tail = probability[0];
        if (tail > level / 2) return std::nullopt;
        std::size_t left_out = 0;
        while (tail + probability[2 * (left_out + 1)] <= level / 2) {
            ++left_out;
            tail += probability[2 * left_out];
        }
        return left_out;
    }
    const auto n = static_cast<double>(count);
    const double quantile = boost::math::quantile(boost::math::complement(boost::math::normal(), level / 2));
    const double bound = n * (n + 1) / 4 - 0.5 - quantile * std::sqrt(variance_of_rank_sum(n, 0));
    if (bound < 0) return std::nullopt;
    return static_cast<std::size_t>(bound);
}

}  // namespace

double signed_rank_p_above(std::span<const double> values) {
    assert(!values.empty());
    const SignedRanks ranks = rank(values);
    if (ranks.doubled.empty()) return 1;
    if (ranks.doubled.size() <= max_values_for_exact) {
        const std::vector<double> probability = distribution_of_rank_sum(ranks.doubled);
        double tail = 0;
        for (std::size_t sum = probability.size(); sum-- > ranks.doubled_sum_of_positive;) {
            tail += probability[sum];
        }
        return std::min(tail, 1.0);
    }
    const auto count = static_cast<double>(ranks.doubled.size());
    const double sum = static_cast<double>(ranks.doubled_sum_of_positive) / 2;
    const double above_mean = sum - count * (count + 1) / 4 - 0.5;  // continuity
    const double z = above_mean / std::sqrt(variance_of_rank_sum(count, ranks.ties));
    return boost::math::cdf(boost::math::complement(boost::math::normal(), z));
}

ShiftEstimate signed_rank_shift(std::span<const double> values, double level) {
    assert(!values.empty() && level > 0 && level < 1);
    const WalshAverages averages(values);
    const std::size_t middle = (averages.count() - 1) / 2;
    ShiftEstimate shift;
    shift.centre = averages.nth(middle);
    if (averages.count() % 2 == 0) shift.centre = std::midpoint(shift.centre, averages.nth(middle + 1));
    if (const auto left_out = left_out_at_each_end(values.size(), level)) {
        shift.interval = Interval{averages.nth(*left_out), averages.nth(averages.count() - 1 - *left_out)};
    }
    return shift;
}

}  // namespace reliefbench
