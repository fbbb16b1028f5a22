#pragma once

#include "compare/comparison.hpp"
#include "compare/run_side.hpp"

#include <span>
#include <vector>

namespace reliefbench {

/// The cells of two sides that can be compared, with their quality (of each side's first run: it is deterministic) and
/// without times yet; why the others cannot; what differs between the runs.
Comparison pair_runs(const RunSide& base, const RunSide& changed, const std::vector<DecidingFigure>& deciding);

/// Of stored runs, at least one a side: of quality alone, which one run a side decides, on whatever devices.
Comparison compare_quality_of_runs(std::span<const StoredRun> base, std::span<const StoredRun> changed,
                                   const std::vector<DecidingFigure>& deciding);

}  // namespace reliefbench
