#include "compare/between_runs.hpp"

#include "compare/evidence.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace reliefbench {

namespace {

/// More than anyone will make: what would take as many is not worth telling.
constexpr std::size_t max_runs = 1000;

/// Fewer say too little of how far identical code lies apart.
constexpr std::size_t min_control_cells = 10;

/// Without the detour over long double, which costs more than half of the time.
using StudentsT =
    boost::math::students_t_distribution<double,
                                         boost::math::policies::policy<boost::math::policies::promote_double<false>>>;

struct Side {
    double mean = 0;
    double squares = 0;
    double count = 0;
};

/// Of the logarithms.
Side side_of(std::span<const double> milliseconds) {
    Side side;
    side.count = static_cast<double>(milliseconds.size());
    for (const double value : milliseconds) {
        assert(value > 0);
        side.mean += std::log(value) / side.count;
    }
    for (const double value : milliseconds) {
        const double deviation = std::log(value) - side.mean;
        side.squares += deviation * deviation;
    }
    return side;
}

double upper_quantile(double p, double degrees_of_freedom) {
    return boost::math::quantile(boost::math::complement(StudentsT(degrees_of_freedom), p));
}

/// The p-value that the truth is at most 0, of an estimate with its standard error.
double p_above(double estimate, double standard_error, double degrees_of_freedom) {
    if (standard_error == 0) return estimate > 0 ? 0 : 1;
    const StudentsT distribution(degrees_of_freedom);
    return boost::math::cdf(boost::math::complement(distribution, estimate / standard_error));
}

}  // namespace

RatioEstimate estimate_between_runs(std::span<const double> base_ms, std::span<const double> new_ms,
                                    const RunNoise& noise, double threshold, double level, double inflation) {
    assert(!base_ms.empty() && !new_ms.empty());
    const Side base = side_of(base_ms);
    const Side changed = side_of(new_ms);
    const double own_freedom = base.count + changed.count - 2;
    const double freedom = own_freedom + noise.degrees_of_freedom;
    assert(freedom > 0);
    const double variance = inflation * inflation *
                            (base.squares + changed.squares + noise.degrees_of_freedom * noise.log_sd * noise.log_sd) /
                            freedom;

    // With as many runs more on each side.
    const std::size_t units = std::min(base_ms.size(), new_ms.size());
    const auto reach = [&](double p, std::size_t with_units) {
        const auto more = static_cast<double>(with_units - units);
        const double standard_error = std::sqrt(variance * (1 / (base.count + more) + 1 / (changed.count + more)));
        return upper_quantile(p, freedom + 2 * more) * standard_error;
    };
    Evidence evidence;
    evidence.log_ratio = changed.mean - base.mean;
    evidence.units = units;
    evidence.interval_reach = [&](std::size_t with_units) { return reach(0.025, with_units); };
    evidence.verdict_reach = [&](std::size_t with_units) { return reach(level / 2, with_units); };
    evidence.unchanged_reach = [&](std::size_t with_units) { return reach(highest_p_unchanged / 2, with_units); };
    evidence.unlucky_reach = [&](std::size_t with_units) { return reach(0.01, with_units); };

    const double standard_error = std::sqrt(variance * (1 / base.count + 1 / changed.count));
    const double log_threshold = std::log1p(threshold);
    const double half_width = evidence.interval_reach(units);
    RatioEstimate estimate;
    estimate.ratio = std::exp(evidence.log_ratio);
    estimate.ci95 = {std::exp(evidence.log_ratio - half_width), std::exp(evidence.log_ratio + half_width)};
    estimate.p_slower = p_above(evidence.log_ratio - log_threshold, standard_error, freedom);
    estimate.p_faster = p_above(-evidence.log_ratio - log_threshold, standard_error, freedom);
    estimate.p_unchanged = std::min(1.0, 2 * p_above(std::abs(evidence.log_ratio), standard_error, freedom));
    estimate.visible = visible_change(evidence, threshold);
    estimate.units = units;
    estimate.more = more_units(evidence, threshold, max_runs);
    return estimate;
}

double noise_inflation(std::span<const ControlCell> cells) {
    if (cells.size() < min_control_cells) return 1;
    std::vector<double> distances;
    for (const ControlCell& cell : cells) {
        const double half_width = std::log(cell.estimate.ci95.high / cell.estimate.ci95.low) / 2;
        if (half_width <= 0) continue;
        // In quartiles of t: as many lie below 1 as above.
        const double quartile =
            half_width * upper_quantile(0.25, cell.degrees_of_freedom) / upper_quantile(0.025, cell.degrees_of_freedom);
        distances.push_back(std::abs(std::log(cell.estimate.ratio)) / quartile);
    }
    return distances.size() < min_control_cells ? 1 : std::max(1.0, median(distances));
}

}  // namespace reliefbench
