#pragma once

#include "compare/comparison.hpp"
#include "measure/variants.hpp"

#include <cstddef>
#include <vector>

namespace reliefbench {

/// Of the cells compared together, how many of those called slower or faster may be called so wrongly.
inline constexpr double live_false_discovery_rate = 0.05;

/// Stops a cell at the first look at which its verdict stands, whatever the other `cells - 1` come to.
CellIsDecided decided_at_looks(double threshold, std::size_t cells);

/// Estimates, verdicts, changes of quality and reasons; notices and environment are left to the caller.
Comparison compare_variants(const VariantOutcome& outcome, double threshold,
                            const std::vector<DecidingFigure>& deciding = default_deciding_figures());

}  // namespace reliefbench
