#pragma once

#include "scene/image.hpp"

#include <array>
#include <cstdint>

namespace reliefbench {

/// The footprint F of a view, and what its pictures show where there is nothing.
struct Footprint {
    /// Not 0 in the pixels of F.
    const Image<std::uint8_t>& inside;
    /// Linear RGB.
    std::array<float, 3> background;
};

/// Whether the picture shows nothing but the background outside F.
bool is_background_outside(const Image<std::array<float, 3>>& picture, const Footprint& footprint);

/// What only real geometry can draw there, the relief seen past the flat polygon's outline, is then in neither of two
/// pictures, nor reaches F by a filter.
void set_background_outside(Image<std::array<float, 3>>& picture, const Footprint& footprint);

}  // namespace reliefbench
