#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// Figures that a cell has, for people to read at once: those whose labels begin alike and that have one unit share a
/// line ("UV error: p99 0.125, median 0.0312 texels"). What is undefined is left out.

/// All but times, in the order of the list.
std::vector<std::string> figure_lines(const CellResult& cell);

/// Those of `paths`, in their order; each is declared.
std::vector<std::string> figure_lines(const CellResult& cell, const std::vector<std::string_view>& paths);

}  // namespace reliefbench
