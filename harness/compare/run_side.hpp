#pragma once

#include "compare/stored_run.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace reliefbench {

/// The pass whose time is compared.
inline constexpr const char* compared_pass = draw_pass;

/// Which of a pass's figures stands for a run: the lower quartile where all that are compared have it.
enum class Figure { lower_quartile, median };
double figure_of(const PassTiming& timing, Figure figure);

/// One cell over the runs of a side.
struct SideCell {
    /// Measured, each with its run.
    std::vector<const CellResult*> measured;
    std::vector<const StoredRun*> runs;
    /// The first result that has no time.
    const CellResult* unmeasured = nullptr;

    bool has_lower_quartiles() const;
    /// Of the compared pass, one per run that measured the cell.
    std::vector<double> milliseconds(Figure figure) const;
};

/// The runs of one side by cell; refers to them.
struct RunSide {
    std::span<const StoredRun> runs;
    /// In the order of their first appearance.
    std::vector<std::string> order;
    std::unordered_map<std::string, SideCell> cells;
};

/// The result has a positive time of the compared pass.
bool is_timed(const CellResult& result);
/// The cell was drawn, whether or not it could be timed.
bool has_figures(const CellResult& result);

/// Runs that differ in device, or in what one of their cells is of (subject_difference), are an Error. At least one
/// run.
RunSide gather_side(std::span<const StoredRun> runs, bool (*is_measured)(const CellResult&) = is_timed);

/// Why no run measured the cell, or why some did not: "failed: lost device".
std::string unmeasured_text(const SideCell& cell);

/// "; measured in 3 of 5 base runs only (in the others failed: ...)", or nothing when every run has the cell.
std::string partial_text(const SideCell& cell, std::size_t runs, std::string_view side);

/// How uncertain the medians of both sides are by their own runs' intervals: the standard deviation of a logarithm.
double deviation_within_runs(const SideCell& base, const SideCell& changed);

}  // namespace reliefbench
