#pragma once

#include "scene/image.hpp"

#include <cstdint>

namespace reliefbench {

/// What the search of one pixel cost; shading is not counted.
struct PixelWork {
    std::uint32_t taps = 0;
    std::uint32_t texels = 0;
    std::uint32_t steps = 0;
    /// Searches that ended by their cap where they could still have hit something.
    std::uint32_t unconverged = 0;
    /// Whether the device ended its loops, or those of a pixel that it runs beside it (gpu/loop_limit.hpp).
    bool cut = false;
};

/// Of the covered pixels, those with a search that did not converge; 0 where none is covered.
double unconverged_fraction(const Image<std::uint8_t>& covered, const Image<PixelWork>& work);

}  // namespace reliefbench
