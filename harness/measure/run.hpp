#pragma once

#include "measure/clock.hpp"
#include "store/cell_result.hpp"
#include "store/resume.hpp"
#include "store/run_folder.hpp"
#include "sweep/configuration.hpp"
#include "technique/technique.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace reliefbench {

namespace gpu {
class Device;
}

/// What a run tells while it goes on.
struct Progress {
    std::size_t cells_done = 0;
    std::size_t cells_total = 0;
    /// Cell or stage being worked on.
    std::string current;
    double elapsed_s = 0;
    /// Estimated from what cells took so far; negative while unknown.
    double remaining_s = -1;
};

/// Where the wall time went, for the line at the end of a run.
struct TimeSplit {
    double total_s = 0;
    /// Inside GPU timestamps of counted samples.
    double samples_s = 0;
    double truth_s = 0;
    /// From the first visit of a block to its last, of all blocks, and what of it lay inside GPU timestamps of counted
    /// samples.
    double timing_s = 0;
    double timing_samples_s = 0;
};

struct MeasureOptions {
    /// Visits that the device may have at once; empty: one on a CPU device, where the host's work would take processors
    /// away from the samples, else two.
    std::optional<std::size_t> in_flight = {};
    /// Where derived maps that take long to make are kept (technique/map_cache.hpp); empty: nowhere.
    std::filesystem::path map_cache = {};
    /// Of an interrupted execution of the same cells: finished ones stay as they are, the others go on with the rounds
    /// they have.
    EarlierWork earlier = {};
    /// Whether to end early, with what is done; asked between any two pieces of work. May be empty.
    std::function<bool()> is_interrupted = {};
};

struct RunOutcome {
    /// Of an interrupted run those that are finished.
    std::vector<CellResult> cells;
    bool interrupted = false;
    TimeSplit split;
};

/// Measures every cell, block by block: truths once per view, compile, prepare, probe (errors and work, and errors in
/// motion where they are asked for), warm up, sample in rounds, then append the block's cells to the run's folder and
/// free its truths and pipelines. What fails is a cell's failure; an Error of the store (a full disk) ends the run.
/// When it is interrupted the visits at hand are finished; every sample is in the folder then, so that the run can be
/// gone on with.
RunOutcome run_cells(const gpu::Device& device, const TechniqueLibrary& library, const Configuration& configuration,
                     const std::vector<Cell>& cells, RunWriter& writer,
                     const std::function<void(const Progress&)>& on_progress, const Clock& clock = steady_clock(),
                     const MeasureOptions& options = {});

}  // namespace reliefbench
