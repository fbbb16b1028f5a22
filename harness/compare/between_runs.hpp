#pragma once

#include "compare/ratio_estimate.hpp"
#include "store/noise_record.hpp"

#include <span>

namespace reliefbench {

/// From stored runs: one median (ms) of a cell and pass per run. The run is the unit of evidence. With few runs a side
/// `noise` says how far the medians of identical runs lie apart on this machine. At least one run a side.
RatioEstimate estimate_between_runs(std::span<const double> base_ms, std::span<const double> new_ms,
                                    const RunNoise& noise, double threshold);

}  // namespace reliefbench
