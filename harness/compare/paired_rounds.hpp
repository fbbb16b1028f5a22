#pragma once

#include "compare/ratio_estimate.hpp"

#include <span>

namespace reliefbench {

/// From interleaved pairs in one process: each value is log(new ms / base ms) of one round. The estimate is the
/// Hodges-Lehmann median of the Walsh averages with its signed-rank interval (Hollander, Wolfe & Chicken
/// 2014, 3.2-3.3): under random order within a pair, identical code makes the differences symmetric about 0, which is
/// all that the test assumes. `threshold` is a fraction; `level` the two-sided error level that this look may spend
/// (LookSchedule).
RatioEstimate estimate_paired(std::span<const double> log_ratios, double threshold, double level = 0.05);

}  // namespace reliefbench
