#pragma once

#include "compare/comparison.hpp"
#include "compare/stored_run.hpp"
#include "store/noise_record.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace reliefbench {

struct CompareOptions {
    /// The smallest change of time that matters, as a fraction.
    double threshold = 0.02;
    /// Of the verdicts slower and faster, the share that may be wrong (Benjamini & Hochberg over all cells).
    double false_discovery_rate = 0.01;
    std::vector<DecidingFigure> deciding_figures = default_deciding_figures();
    /// Compare runs of different devices all the same.
    bool across_devices = false;
};

/// The noise kept for a machine, if any (read_noise_record).
using NoiseLookup = std::function<std::optional<NoiseRecord>(const MachineKey&)>;

/// Stored runs, at least one a side, in any order. Cells are paired by id over all runs of a side; the time compared is
/// that of the pass "draw", and of quality, which is deterministic, each side's first run. What cannot be compared is
/// told in `uncompared`. From six runs on (both sides together) the noise between runs is the runs' own; with fewer it
/// is the machine's, or the stated default, and never less than what the runs' own intervals say. Runs of different
/// devices, or runs of one side that differ in device or height maps, are an Error.
Comparison compare_runs(std::span<const StoredRun> base, std::span<const StoredRun> changed,
                        const CompareOptions& options, const NoiseLookup& find_noise);

}  // namespace reliefbench
