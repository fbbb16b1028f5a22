#pragma once

#include "metrics/coverage.hpp"
#include "picture/picture.hpp"
#include "picture/pixel_map.hpp"
#include "picture/text.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// The values' colours. Where a value is not a number, what the scale says of such: by coverage, blue is missed, cyan
/// the same outside the footprint, green a false hit; grey is nothing. Images of equal size.
Picture map_picture(const PixelMapScale& scale, const Image<float>& values, const Image<Coverage>& coverage);

/// A colour that stands for no value of a map, and what for.
struct Swatch {
    Rgb8 colour;
    std::string text;
};

/// Those of the scale's maps.
std::vector<Swatch> swatches_of(const PixelMapScale& scale);

/// Title and unit, the colour bar with its numbers, and the colours of what is not on it; as wide as asked for, but not
/// narrower than it can be read.
Picture legend(const PixelMapScale& scale, int width, const Font& font);

}  // namespace reliefbench
