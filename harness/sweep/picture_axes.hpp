#pragma once

#include "sweep/view_axes.hpp"

#include <vector>

namespace reliefbench {

/// `samples_per_pixel` and `frames`: rows of the table of axes.
std::vector<ViewAxis> picture_axes();

}  // namespace reliefbench
