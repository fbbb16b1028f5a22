#include "compare/paired_rounds.hpp"

#include "compare/evidence.hpp"
#include "compare/signed_rank.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace reliefbench {

namespace {

/// Rounds take milliseconds, but nobody waits for more than this.
constexpr std::size_t max_rounds = 100000;

double normal_upper_quantile(double p) {
    return boost::math::quantile(boost::math::complement(boost::math::normal(), p));
}

RatioEstimate nothing_known(std::size_t rounds, double ratio) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    RatioEstimate estimate;
    estimate.ratio = ratio;
    estimate.ci95 = {0, infinity};
    estimate.visible = infinity;
    estimate.units = rounds;
    return estimate;
}

double p_above(std::span<const double> values, double bound, double sign) {
    std::vector<double> shifted;
    shifted.reserve(values.size());
    for (const double value : values) {
        shifted.push_back(sign * value - bound);
    }
    return signed_rank_p_above(shifted);
}

}  // namespace

RatioEstimate estimate_paired(std::span<const double> log_ratios, double threshold, double look_level, double level) {
    const std::size_t rounds = log_ratios.size();
    if (rounds == 0) return nothing_known(0, 1);
    const ShiftEstimate shift = signed_rank_shift(log_ratios, look_level);
    if (!shift.interval) return nothing_known(rounds, std::exp(shift.centre));

    const double share_of_look = look_level / 0.05;
    const double log_threshold = std::log1p(threshold);
    const double interval_quantile = normal_upper_quantile(look_level / 2);
    const double half_width = (shift.interval->high - shift.interval->low) / 2;
    // The interval says how far estimates like this one scatter, whatever the distribution of the rounds.
    const auto reach = [&](double p, std::size_t with_rounds) {
        const double growth = static_cast<double>(with_rounds) / static_cast<double>(rounds);
        return normal_upper_quantile(p) / interval_quantile * half_width / std::sqrt(growth);
    };
    Evidence evidence;
    evidence.log_ratio = shift.centre;
    evidence.units = rounds;
    evidence.interval_reach = [&](std::size_t with_rounds) { return reach(look_level / 2, with_rounds); };
    evidence.verdict_reach = [&](std::size_t with_rounds) { return reach(level / 2 * share_of_look, with_rounds); };
    evidence.unchanged_reach = [&](std::size_t with_rounds) {
        return reach(highest_p_unchanged / 2 * share_of_look, with_rounds);
    };
    evidence.unlucky_reach = [&](std::size_t with_rounds) { return reach(0.01, with_rounds); };

    RatioEstimate estimate;
    estimate.ratio = std::exp(shift.centre);
    estimate.ci95 = {std::exp(shift.interval->low), std::exp(shift.interval->high)};
    estimate.p_slower = std::min(1.0, p_above(log_ratios, log_threshold, 1) / share_of_look);
    estimate.p_faster = std::min(1.0, p_above(log_ratios, log_threshold, -1) / share_of_look);
    const double p_one_sided = std::min(p_above(log_ratios, 0, 1), p_above(log_ratios, 0, -1));
    estimate.p_unchanged = std::min(1.0, 2 * p_one_sided / share_of_look);
    estimate.visible = visible_change(evidence, threshold);
    estimate.units = rounds;
    estimate.more = more_units(evidence, threshold, max_rounds);
    return estimate;
}

}  // namespace reliefbench
