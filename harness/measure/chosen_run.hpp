#pragma once

#include "measure/run.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace reliefbench {

/// Says which cells of a run are worth measuring, from what was seen of those that were. Cells are named by their index
/// in the run.
class CellChooser {
public:
    virtual ~CellChooser() = default;

    /// The cell was drawn once and has its figures, or has ended as skipped or failed.
    virtual void add_result(std::size_t cell, const CellResult& result) = 0;
    /// Of the draw, after every visit. `is_settled`: the cell needs no more rounds, or gets none.
    virtual void add_times(std::size_t cell, const PassTiming& draw, bool is_settled) = 0;

    /// The cells to visit once more; those without a result are made ready first. Empty: it is done.
    virtual std::vector<std::size_t> next_round() = 0;
    /// Why a cell without a result was not worth measuring; empty while it may be.
    virtual std::string reason_left_out(std::size_t cell) const = 0;
    /// For the line of progress: "12 settings in question".
    virtual std::string standing() const = 0;
};

struct ChosenOptions : MeasureOptions {
    /// Of the clock: no visit begins later. What was measured by then is recorded.
    double deadline_s = 0;
    /// Those that are ready at a time, at most; what was visited least lately is made ready anew when it is wanted.
    std::size_t max_ready = 64;
    /// Of `earlier.finished`.
    std::vector<CellResult> finished = {};
    /// Recorded when an earlier execution's deadline cut them off, and taken out of the folder: they go on with their
    /// samples, which `earlier.visits` has, and are recorded again.
    std::vector<CellResult> cut_off = {};
};

struct ChosenOutcome : RunOutcome {
    /// The deadline came before the chooser was done.
    bool is_time_over = false;
};

/// Measures cells in rounds as long as `chooser` wants any: all of them stay together from the first to the last round,
/// so that what is compared in the end was sampled in the same minutes. The chooser is told when the configuration's
/// rule would stop a cell. In the end those with samples are finished as they are (where the rule does not stop them
/// StopReason::narrowed, or `time` where the deadline cut them off), and those that were not worth measuring are
/// skipped with the reason; where the deadline came first, what was not measured stays unfinished, for a run that goes
/// on. Interrupted, it leaves all unfinished, with their samples in the folder.
ChosenOutcome run_chosen_cells(CellSource& source, const Configuration& configuration, const std::vector<Cell>& cells,
                               RunWriter& writer, CellChooser& chooser,
                               const std::function<void(const Progress&)>& on_progress, const Clock& clock,
                               const ChosenOptions& options);

}  // namespace reliefbench
