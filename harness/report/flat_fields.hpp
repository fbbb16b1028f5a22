#pragma once

#include "store/cell_result.hpp"

#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// Scalars by their path in a line of cells.jsonl ("error.uv_texels.p99"; the bounds of an interval are ".low" and
/// ".high"), in the order of the file. A group that is undefined as a whole is one null ("error").
using FlatFields = std::vector<std::pair<std::string, Json>>;

FlatFields flat_fields(const CellResult& cell);

}  // namespace reliefbench
