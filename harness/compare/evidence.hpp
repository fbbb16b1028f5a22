#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace reliefbench {

/// How evidence about a log ratio narrows as it grows: what `visible` and `more` of an estimate are made from.
struct Evidence {
    double log_ratio = 0;
    /// Rounds, or runs a side, at hand.
    std::size_t units = 0;
    /// Half the width of the interval of the log ratio with `units`, and how far beyond the threshold it has to lie for
    /// a verdict.
    std::function<double(std::size_t units)> interval_reach;
    std::function<double(std::size_t units)> verdict_reach;
    /// How far from 0 the log ratio has to lie for a verdict.
    std::function<double(std::size_t units)> unchanged_reach;
    /// How far chance takes an estimate below the truth once in a hundred.
    std::function<double(std::size_t units)> unlucky_reach;
};

/// As a fraction: RatioEstimate::visible.
double visible_change(const Evidence& evidence, double threshold);

/// How many more units decide if the log ratio stays: RatioEstimate::more. Empty beyond `max_units`.
std::optional<std::size_t> more_units(const Evidence& evidence, double threshold, std::size_t max_units);

}  // namespace reliefbench
