#pragma once

#include "core/figure.hpp"
#include "scene/hit.hpp"
#include "scene/image.hpp"

#include <cstdint>
#include <vector>

namespace reliefbench {

/// Of a technique whose fragments are the base's: the pixels in which the rasteriser draws the base and the ray through
/// the centre does not meet it, or the other way round, as a fraction of the footprint's; 0 where that is empty. Not 0
/// in `covered`: a fragment ran. Images of equal size.
double raster_mismatch(const Image<std::uint8_t>& covered, const FootprintImage& footprint);

std::vector<FigureDeclaration> raster_mismatch_figures();
FigureValueList figures_of_raster_mismatch(double fraction);

}  // namespace reliefbench
