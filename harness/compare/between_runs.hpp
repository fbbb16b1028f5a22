#pragma once

#include "compare/ratio_estimate.hpp"
#include "store/noise_record.hpp"

#include <span>

namespace reliefbench {

/// From stored runs: one median (ms, positive) of a cell and pass per run, at least one a side. The run is the unit of
/// evidence: a t interval on the logarithms, whose variance is pooled from both sides (identical code on one machine
/// has one variance, and Welch's has too few degrees of freedom with three runs) and from `noise`, each weighted by its
/// degrees of freedom: the moderated t of Smyth (2004). With one run a side it is the noise alone; noise of no degrees
/// of freedom is left out where the runs have some of their own. `level`: the two-sided p-value of being beyond
/// the threshold that a verdict must pass, for `visible` and `more`.
RatioEstimate estimate_between_runs(std::span<const double> base_ms, std::span<const double> new_ms,
                                    const RunNoise& noise, double threshold, double level = highest_p_unchanged,
                                    double inflation = 1);

/// One cell that runs the same code on both sides: its estimate, made without inflation, and how many degrees of
/// freedom that has.
struct ControlCell {
    RatioEstimate estimate;
    double degrees_of_freedom = 0;
};

/// How many times as far from 1 the ratios of identical code lie as their noise accounts for, at least 1: the machine
/// was in another state on the other side, which no spread within a side shows. The median over cells, as in genomic
/// control (Devlin & Roeder 1999). With fewer than ten cells 1.
double noise_inflation(std::span<const ControlCell> cells);

}  // namespace reliefbench
