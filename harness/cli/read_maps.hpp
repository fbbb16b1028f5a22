#pragma once

#include "measure/shared_inputs.hpp"

#include <vector>

namespace reliefbench {

/// inspect_height_maps, with progress on stderr: many and large ones take long.
std::vector<HeightMapRecord> read_maps(const std::vector<Cell>& cells);

}  // namespace reliefbench
