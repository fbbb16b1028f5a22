#pragma once

#include "compare/stored_run.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace reliefbench {

struct HistoryOptions {
    /// The smallest step that matters, as a fraction.
    double minimum_effect = 0.02;
    /// Of the change points, the share that may be wrong (Benjamini & Hochberg over all cells).
    double false_discovery_rate = 0.01;
};

/// A step in a cell's time. Runs are counted from 0.
struct ChangePoint {
    /// The first run after the step, and the last one before it that has the cell.
    std::size_t run = 0;
    std::size_t previous = 0;
    /// Median of the segment after the step / median of the one before it.
    double ratio = 1;
    /// Two-sided, corrected for all places where the step could have been.
    double p = 1;
};

struct CellHistory {
    std::string cell;
    /// Of the pass "draw", by run; empty where a run lacks the cell, or had another subject under its id (parameters,
    /// height map) than the newest run.
    std::vector<std::optional<double>> median_ms;
    std::vector<ChangePoint> changes;
};

/// Cells whose change points fall on the same run, give or take one, and go the same way.
struct MovedTogether {
    std::size_t run = 0;
    bool slower = false;
    /// Indices into History::cells.
    std::vector<std::size_t> cells;
    double smallest_ratio = 1;
    double largest_ratio = 1;
    /// "between run 7 and 8: 12 cells slower, 1.21 to 1.34 times", runs counted from 1.
    std::string text;
};

/// What changed in the record of a run against the run before it: driver, sources, sampling, in words.
struct RecordChange {
    std::size_t run = 0;
    std::vector<std::string> differences;
};

struct History {
    std::vector<std::string> runs;
    std::vector<CellHistory> cells;
    /// By run.
    std::vector<MovedTogether> groups;
    std::vector<RecordChange> record_changes;
};

/// Change points of one series of log times, at least three values a segment. Candidates are the optimal partition of
/// the series (Jackson et al. 2005) into segments of least absolute deviation from their medians, so that outliers draw
/// no segments of their own; each then has to pass a t test between its two neighbouring segments, the weakest leaving
/// first. Parametric, unlike E-divisive (Matteson & James 2014), because its permutations need more runs than most
/// histories have: with 3 + 3 runs none of the 20 orders gives a p-value below 0.05, whatever the step.
/// Here `run` and `previous` are indices into the series.
std::vector<ChangePoint> find_change_points(std::span<const double> log_ms, double minimum_effect, double p_limit);

/// Runs in the order given. Runs of different devices are an Error. A machine's state moves times as a change of code
/// does: cells of all techniques moving together are its sign.
History make_history(std::span<const StoredRun> runs, const HistoryOptions& options);

}  // namespace reliefbench
