#pragma once

#include "store/cell_result.hpp"

#include <vector>

namespace reliefbench {

/// Cells as the report's page reads them: one column per field instead of one object per cell, so that 10,000 cells
/// stay small and load fast. `{"count", "id": [...], "words": {field: column}, "axes": {axis: column}, "parameters":
/// {parameter: column}, "numbers": {path: [...]}}`. A column of words, axes and parameters is `{"values": [...],
/// "index": [...]}`, its distinct values in the order in which cells first have them and one index per cell, -1 where
/// the cell has none. Numbers are rounded to six significant digits, null where undefined; one that no cell has is left
/// out.
Json cells_to_columns(const std::vector<CellResult>& cells);

/// To six significant digits, which print as such; null when it is not finite.
Json rounded_number(double value);

}  // namespace reliefbench
