#pragma once

#include "measure/clock.hpp"
#include "measure/paired_rounds.hpp"
#include "measure/run.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/technique.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace reliefbench {

namespace gpu {
class Device;
}

/// What is measured against each other: the same cells with the techniques of two libraries.
struct Variants {
    const TechniqueLibrary& base;
    const TechniqueLibrary& changed;
};

struct VariantSettings {
    /// Where truths and derived maps are cached (core/cache_folder.hpp); empty: nowhere.
    std::filesystem::path cache = {};
    /// Wall time of sampling, divided among the cells. Preparing them and tracing their truths comes on top.
    double budget_s = 300;
    std::uint64_t seed = 1;
    int samples_per_visit = 5;
    /// In place of the configuration's: many short visits are worth more than few long ones, the more so where other
    /// processes take the device away.
    double minimum_pass_ms = 1;
};

/// A cell that both sides were measured in. The results have errors, work and preparation, and no time of the draw.
struct MeasuredPair {
    CellResult base;
    CellResult changed;
    LogRatios log_ratios;
};

/// A cell that was not measured on both sides, and why.
struct UnmeasuredPair {
    std::string cell;
    std::string reason;
    /// The baseline can do what the changed side failed at.
    bool failed_now = false;
};

struct VariantOutcome {
    std::vector<MeasuredPair> measured;
    std::vector<UnmeasuredPair> unmeasured;
    double sampling_s = 0;
};

/// True when the log ratios of a cell need no more rounds; asked after each.
using CellIsDecided = std::function<bool(const LogRatios& log_ratios)>;

/// One visit of both sides of a cell, as it was timed.
struct VariantVisit {
    const std::string& cell;
    /// Draws inside one timestamp pair.
    int repeats = 1;
    const PairVisit& visit;
};

struct VariantCallbacks {
    CellIsDecided is_decided;
    /// May be empty.
    std::function<void(const Progress&)> on_progress;
    std::function<void(const VariantVisit&)> on_visit;
};

/// Why the baseline has no such cell; empty when it has the same one: its technique takes the same parameters, and
/// under its defaults the cell would have the same id.
std::string missing_in_baseline(const Cell& cell, const TechniqueLibrary& base, const TechniqueLibrary& changed);

/// The cell as the baseline's technique draws it: parameters that only that has are at their defaults, those that it
/// lacks (at their defaults, see missing_in_baseline) are left out.
Cell baseline_cell(const Cell& cell, const Manifest& base);

/// Prepares every cell of a block on both sides, against the same truth, and samples the pairs (sample_pairs); then
/// the next block with what is left of the budget.
VariantOutcome measure_variants(const gpu::Device& device, const Variants& variants, const Configuration& configuration,
                                const std::vector<Cell>& cells, const VariantSettings& settings,
                                const VariantCallbacks& callbacks, const Clock& clock = steady_clock());

}  // namespace reliefbench
