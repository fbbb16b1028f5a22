#pragma once

#include "store/run_folder.hpp"

#include <string>

namespace reliefbench {

/// One row per cell, whatever its status. Columns are the fields of cells.jsonl with their path as the name
/// ("error.uv_texels.p99"; the bounds of an interval are ".low" and ".high"): first all that every run has, in the same
/// order always, then within each group what only this run has (axes, parameters, passes, pipeline statistics). What is
/// undefined is empty. Quoted as RFC 4180 says, lines end in a line feed.
std::string format_csv(const Run& run);

}  // namespace reliefbench
