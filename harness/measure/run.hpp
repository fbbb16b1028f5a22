#pragma once

#include "measure/cell_source.hpp"
#include "measure/clock.hpp"
#include "measure/run_log.hpp"
#include "store/resume.hpp"
#include "store/run_folder.hpp"
#include "store/run_tally.hpp"
#include "sweep/configuration.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace reliefbench {

/// What a run tells while it goes on.
struct Progress {
    std::size_t cells_done = 0;
    std::size_t cells_total = 0;
    /// What is being done, in words, and how much of it: "preparing 3 of 64, compiling"; may be empty.
    std::string stage = {};
    /// Cell or thing that it is being done to.
    std::string current;
    double elapsed_s = 0;
    /// Estimated from what cells took so far; negative while unknown.
    double remaining_s = -1;
    /// How much of the whole is done, in [0, 1]; negative while unknown. It never shrinks, though estimates change.
    double share = -1;
};

struct MeasureOptions {
    /// Of an interrupted execution of the same cells: finished ones stay as they are, the others continue with the
    /// rounds they have. One that too many worker processes died on is failed without another try.
    EarlierWork earlier = {};
    /// Whether to end early, with what is done; asked between any two pieces of work. May be empty.
    std::function<bool()> is_interrupted = {};
    /// Told the cell that is worked on, whenever it changes; empty between cells. May be empty.
    std::function<void(const std::string& cell)> on_cell = {};
};

struct RunOutcome {
    /// Of the cells that this execution finished; they themselves are in the run's folder.
    RunTally tally;
    /// Not all cells are finished: it was told to end, or the device was lost.
    bool ended_early = false;
    bool device_lost = false;
    TimeSplit split;
};

/// Measures every cell, block by block: truths once per view, compile, prepare, probe (errors and work, and errors in
/// motion where they are asked for), warm up, sample in rounds, then append the block's cells to the run's folder and
/// free its truths and pipelines. What fails is a cell's failure; an Error of the store (a full disk) ends the run.
/// When it is interrupted the visits at hand are finished; every sample is in the folder then, so that the run can be
/// resumed. So it is when the device is lost: the cell that lost it is failed, the others wait for a new device.
/// Finished cells are in the folder only: memory does not grow with their number.
RunOutcome run_cells(CellSource& source, const Configuration& configuration, const std::vector<Cell>& cells,
                     RunWriter& writer, const std::function<void(const Progress&)>& on_progress,
                     const Clock& clock = steady_clock(), const MeasureOptions& options = {});

}  // namespace reliefbench
