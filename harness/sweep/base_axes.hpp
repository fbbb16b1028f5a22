#pragma once

#include "sweep/view_axes.hpp"

#include <vector>

namespace reliefbench {

/// `base`, `curvature`, `base_segments` and `base_fit`: rows of the table of axes.
std::vector<ViewAxis> base_axes();

}  // namespace reliefbench
