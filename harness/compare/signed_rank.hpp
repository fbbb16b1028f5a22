#pragma once

#include "core/statistics.hpp"

#include <optional>
#include <span>

namespace reliefbench {

/// Wilcoxon's signed-rank test: the one-sided p-value of "the values are symmetric about 0 or a point below it". Zeros
/// are left out, tied magnitudes share their mean rank. Up to 50 values the distribution given the ranks is exact,
/// above it is normal with the variance corrected for ties. At least one value.
double signed_rank_p_above(std::span<const double> values);

struct ShiftEstimate {
    /// Hodges & Lehmann (1963): the median of the Walsh averages (x_i + x_j) / 2, i <= j.
    double centre = 0;
    /// Of the point of symmetry, at least 1 - level; empty when so few values cannot give one.
    std::optional<Interval> interval;
};

/// n values take O(n log n) time and O(n) memory: the n²/2 Walsh averages are never made.
ShiftEstimate signed_rank_shift(std::span<const double> values, double level);

}  // namespace reliefbench
