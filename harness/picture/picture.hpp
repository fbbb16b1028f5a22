#pragma once

#include "scene/image.hpp"
#include "scene/image_file.hpp"

#include <array>
#include <cstdint>

namespace reliefbench {

/// 8-bit RGB, encoded to sRGB: what is looked at. Row 0 is the top.
using Rgb8 = std::array<std::uint8_t, 3>;
using Picture = Image<Rgb8>;

/// sRGB-encoded values in [0, 1] (clamped), rounded.
Rgb8 to_rgb8(const std::array<double, 3>& encoded);

/// Linear RGB encoded to sRGB.
Picture display_picture(const Image<std::array<float, 3>>& linear);

struct Rectangle {
    int left = 0;
    int top = 0;
    Resolution size;
};

/// Inside the picture.
Picture cropped(const Picture& picture, const Rectangle& part);

/// What does not fit is left out.
void fill(Picture& picture, const Rectangle& area, const Rgb8& colour);
void paste(Picture& picture, int left, int top, const Picture& part);

/// To write it.
RasterFile to_raster(const Picture& picture);

}  // namespace reliefbench
