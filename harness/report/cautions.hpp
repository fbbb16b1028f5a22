#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// What whoever reads these cells' figures has to know before concluding from them, one sentence each:
/// - views in which more than 1 % of the footprint are ties, which no error of hits counts;
/// - that all rays run along rows or columns of texels, where the bilinear surface is a straight line in each cell and
///   errors of linear refinement vanish;
/// - that pictures are filtered and the truth is not, which counts as errors what filters are for.
/// `record`: run.json's.
std::vector<std::string> cautions(const std::vector<CellResult>& cells, const Json& record = Json());

/// The last of them; "" where there is none.
std::string caution_of_truth(const std::vector<CellResult>& cells, const Json& record);

}  // namespace reliefbench
