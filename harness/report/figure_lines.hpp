#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// Figures that a cell has, for people to read at once: neighbours of one group (their paths but for the last part)
/// share a line where their labels begin alike ("UV error: p99 0.1250, median 0.03125 texels") or end alike
/// ("Footprint: FLIP 0.02603, PSNR 26.11 dB"). Four significant digits, counts in full. What is undefined is left out.

/// All but times, in the order of the list.
std::vector<std::string> figure_lines(const CellResult& cell);

/// Those of `paths`, in their order; each is declared.
std::vector<std::string> figure_lines(const CellResult& cell, const std::vector<std::string_view>& paths);

}  // namespace reliefbench
