#pragma once

#include "compare/stored_run.hpp"

#include <span>

namespace reliefbench {

/// Gives every cell the id that it has by the defaults, and the presets, of the newest run, so that equal cells have
/// equal ids: an axis or a parameter that a run does not know is left out, as at its default, and one that is no longer
/// the default, or the preset's value, is named. Parameters and axes themselves stay as recorded.
void give_common_ids(std::span<StoredRun> runs);

}  // namespace reliefbench
