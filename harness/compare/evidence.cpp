#include "compare/evidence.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

/// The magnitude of a log ratio beyond which there is a verdict of slower or faster.
double decided_beyond(const Evidence& evidence, double log_threshold, std::size_t units) {
    const double beyond_threshold = std::max(evidence.interval_reach(units), evidence.verdict_reach(units));
    return std::max(log_threshold + beyond_threshold, evidence.unchanged_reach(units));
}

bool decides(const Evidence& evidence, double log_threshold, std::size_t units) {
    const double distance = std::abs(evidence.log_ratio);
    if (distance < log_threshold) return distance + evidence.interval_reach(units) < log_threshold;
    return distance > decided_beyond(evidence, log_threshold, units);
}

}  // namespace

double visible_change(const Evidence& evidence, double threshold) {
    return std::expm1(decided_beyond(evidence, std::log1p(threshold), evidence.units) +
                      evidence.unlucky_reach(evidence.units));
}

std::optional<std::size_t> more_units(const Evidence& evidence, double threshold, std::size_t max_units) {
    const double log_threshold = std::log1p(threshold);
    if (decides(evidence, log_threshold, evidence.units)) return 0;
    std::size_t too_few = evidence.units;
    std::size_t enough = too_few + 1;
    while (!decides(evidence, log_threshold, enough)) {
        if (enough >= max_units) return std::nullopt;
        too_few = enough;
        enough = std::min(2 * enough, max_units);
    }
    while (enough - too_few > 1) {
        const std::size_t middle = too_few + (enough - too_few) / 2;
        (decides(evidence, log_threshold, middle) ? enough : too_few) = middle;
    }
    return enough - evidence.units;
}

}  // namespace reliefbench
