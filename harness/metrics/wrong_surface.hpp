#pragma once

#include "scene/image.hpp"
#include "scene/scene_object.hpp"

#include <cstdint>

namespace reliefbench {

/// The fraction of the footprint's pixels in which one shows the object and the other does not; 0 where the footprint
/// is empty.
double wrong_surface(const Image<Front>& technique, const Image<Front>& truth, const Image<std::uint8_t>& footprint);

}  // namespace reliefbench
