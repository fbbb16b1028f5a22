#pragma once

#include "store/noise_record.hpp"

#include <span>
#include <string>
#include <vector>

namespace reliefbench {

/// The machine's noise between runs, from identical runs (the processes of `reliefbench selfcheck`): the root mean
/// square of the cells' standard deviations. Its degrees of freedom are those of one cell, since what moves all cells
/// at once makes them tell the same thing. Cells of fewer than two processes tell nothing; no cell that does is an
/// Error. `time` is when it was measured, for `source`.
RunNoise pool_noise(std::span<const NoiseRecord::Cell> cells, const std::string& time);

/// One cell's times, ms, of the runs of each side; a run without the cell is left out.
struct CellMedians {
    std::vector<double> base_ms;
    std::vector<double> new_ms;
};

/// What the runs that are compared tell about their own noise: the prior that the moderated t takes for each cell's
/// variance (Smyth 2004, section 6.2). Its degrees of freedom are high where cells are alike, so that cells lend each
/// other what few runs cannot give, but no higher than the cells' correlation between runs allows: cells that all move
/// together lend each other nothing. None (degrees_of_freedom 0) with fewer than three cells that have evidence.
RunNoise noise_of_runs(std::span<const CellMedians> cells);

}  // namespace reliefbench
