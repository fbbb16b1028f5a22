#pragma once

#include "core/figure.hpp"
#include "measure/pictures.hpp"
#include "metrics/work.hpp"
#include "scene/lighting.hpp"
#include "store/cell_times.hpp"
#include "technique/renderer.hpp"

#include <optional>
#include <vector>

namespace reliefbench {

/// Of the fragments and the stages before them; with the taps of self-shadowing where there is any. Empty when nothing
/// is covered.
std::optional<WorkSummary> summarize_work(const Probe& probe, bool self_shadow);

/// Against the truth: hits, pictures, and where there are any shadows and an object. All the figures of one cell but
/// work, times and motion.
FigureValueList errors_of(const DrawnCell& drawn, const Lighting& lighting, bool self_shadow);

/// Needs at least one round, each with a sample. Samples of one round are not independent of each other: the median and
/// its interval are over the rounds' medians.
PassTiming summarize_timing(const std::vector<std::vector<double>>& rounds, int repeats);

/// Milliseconds of the whole preparation: the sum of its passes' medians.
double preparation_ms(const Preparation& preparation);

}  // namespace reliefbench
