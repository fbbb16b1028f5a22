#pragma once

#include "scene/material_filter.hpp"
#include "sweep/view_axes.hpp"

#include <vector>

namespace reliefbench {

/// `material_filter` and its settings: rows of the table of axes.
std::vector<ViewAxis> material_axes();

/// Leaves what the filter has no use for at its default.
void reset_unused(MaterialFilter& material);

}  // namespace reliefbench
