#pragma once

#include "scene/image.hpp"

#include <cstdint>
#include <vector>

namespace reliefbench {

/// Of each pixel of `from` that is not 0, in the order of the image: the Euclidean distance between its centre and that
/// of the nearest pixel of `to` that is not 0, in pixels. Exact, in time linear in the pixels. Images of equal size;
/// `to` has such a pixel.
std::vector<double> distances_between(const Image<std::uint8_t>& from, const Image<std::uint8_t>& to);

}  // namespace reliefbench
