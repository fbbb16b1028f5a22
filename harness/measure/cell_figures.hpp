#pragma once

#include "metrics/work.hpp"
#include "store/cell_times.hpp"
#include "technique/renderer.hpp"

#include <optional>
#include <vector>

namespace reliefbench {

/// Of the fragments and the stages before them; with the taps of self-shadowing where there is any. Empty when nothing
/// is covered.
std::optional<WorkSummary> summarize_work(const Probe& probe, bool self_shadow);

/// Needs at least one round, each with a sample. Samples of one round are not independent of each other: the median and
/// its interval are over the rounds' medians.
PassTiming summarize_timing(const std::vector<std::vector<double>>& rounds, int repeats);

/// Milliseconds of the whole preparation: the sum of its passes' medians.
double preparation_ms(const Preparation& preparation);

}  // namespace reliefbench
