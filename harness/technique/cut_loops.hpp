#pragma once

#include "technique/renderer.hpp"

#include <string>

namespace reliefbench {

/// What the device did to the loops of a draw, one sentence without its full stop; empty where all of them came to
/// their own ends. Hits and picture of a draw with such loops are not the technique's.
std::string describe_cut_loops(const gpu::Device& device, const Probe& probe);

}  // namespace reliefbench
