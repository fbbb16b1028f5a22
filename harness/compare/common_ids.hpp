#pragma once

#include "compare/stored_run.hpp"

#include <span>

namespace reliefbench {

/// Gives every cell the id that it has by the defaults of the newest run, so that equal cells have equal ids: an axis
/// or a parameter that a run does not know is left out, as at its default, and one that is no longer the default is
/// named. Parameters and axes themselves stay as recorded.
void give_common_ids(std::span<StoredRun> runs);

}  // namespace reliefbench
