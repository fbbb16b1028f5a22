#pragma once

#include "compare/stored_run.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// The runs in `folders`, in their order. A folder that holds runs in folders of its own is not expanded, because runs
/// that were not meant would count as evidence: that is an Error which lists them. So is a folder named twice.
std::vector<StoredRun> read_stored_runs(const std::vector<std::string>& folders);

/// Leaves the cells whose id contains any of `texts` (`--cell`); all where there is none. A text that no id contains is
/// an Error.
void keep_cells(std::vector<StoredRun>& runs, const std::vector<std::string>& texts);

}  // namespace reliefbench
