#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// What whoever reads these cells' figures has to know before concluding from them, one sentence each:
/// - views in which more than 1 % of the footprint are ties, which no error of hits counts;
/// - that all rays run along rows or columns of texels, where the bilinear surface is a straight line in each cell and
///   errors of linear refinement vanish.
std::vector<std::string> cautions(const std::vector<CellResult>& cells);

}  // namespace reliefbench
