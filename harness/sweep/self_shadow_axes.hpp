#pragma once

#include "scene/self_shadow.hpp"
#include "sweep/view_axes.hpp"

#include <vector>

namespace reliefbench {

/// The axes of self-shadowing, which move no hits.
std::vector<ViewAxis> self_shadow_axes();

/// What a method has no use for is left at its default.
void reset_unused(SelfShadow& self_shadow);

}  // namespace reliefbench
