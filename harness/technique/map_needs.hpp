#pragma once

#include "manifest/manifest.hpp"
#include "scene/relief.hpp"

#include <string>

namespace reliefbench {

/// Empty when the height map, of this size, and how it lies on the patch are what the technique needs; else the reason
/// for skipping the cell, one sentence without its full stop.
std::string unmet_map_need(const Manifest& manifest, Resolution height_map, const Relief& relief);

}  // namespace reliefbench
