#pragma once

#include "compare/ratio_estimate.hpp"

#include <span>

namespace reliefbench {

/// From interleaved pairs in one process: each value is log(new ms / base ms) of one round. The estimate is the
/// Hodges-Lehmann median of the Walsh averages with its signed-rank interval (Hollander, Wolfe & Chicken
/// 2014, 3.2-3.3): under random order within a pair, identical code makes the differences symmetric about 0, which is
/// all that the test assumes. `threshold` is a fraction. `look_level` is the two-sided error level that this look may
/// spend of 0.05 (look_schedule.hpp): the interval is made at that level and the p-values are multiplied by 0.05 /
/// look_level, so that both hold over all looks together. Too few rounds for that level (fewer than 6 at 0.05): an
/// interval from 0 to infinity. `level`: the two-sided p-value of being beyond the threshold that a verdict must
/// pass, for `visible` and `more`.
RatioEstimate estimate_paired(std::span<const double> log_ratios, double threshold, double look_level = 0.05,
                              double level = highest_p_unchanged);

}  // namespace reliefbench
