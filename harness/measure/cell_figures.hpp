#pragma once

#include "metrics/hit_errors.hpp"
#include "metrics/image_errors.hpp"
#include "metrics/shadow_errors.hpp"
#include "reference/truth.hpp"
#include "store/cell_result.hpp"
#include "technique/renderer.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// Per covered pixel; empty when nothing is covered. Taps and texels of vertex and tessellation stages are spread
/// evenly over the covered pixels.
std::optional<CellResult::Work> summarize_work(const Probe& probe);

/// Adds the taps of self-shadowing.
void add_shadow_work(CellResult::Work& work, const Probe& probe);

CellResult::Errors to_errors(const HitErrors& errors);
CellResult::ShadowErrors to_shadow_errors(const ShadowErrors& errors, const LightVisibility& truth);
CellResult::ImageFields to_image_fields(const ImageComparison& comparison);

/// Needs at least one round, each with a sample. Samples of one round are not independent of each other: the median and
/// its interval are over the rounds' medians.
PassTiming summarize_timing(const std::vector<std::vector<double>>& rounds, int repeats);

/// Milliseconds of the whole preparation: the sum of its passes' medians.
double preparation_ms(const Preparation& preparation);

}  // namespace reliefbench
