#pragma once

#include "reference/truth.hpp"
#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/image_file.hpp"
#include "scene/relief.hpp"

#include <array>
#include <vector>

namespace reliefbench {

/// Linear RGB encoded to sRGB.
RasterFile display_picture(const Image<std::array<float, 3>>& linear);

/// UV error of each pixel in texels on a logarithmic scale from 0.01 (dark) to 10 (light) in the colours of magma.
/// Blue: missed (truth hits, the technique does not). Green: false hit. Grey: neither hits.
RasterFile error_picture(const HitImage& hits, const Truth& truth, const HeightMap& map, const Relief& relief);

/// Pictures of equal height from left to right, parted by a thin line.
RasterFile side_by_side(const std::vector<RasterFile>& pictures);

}  // namespace reliefbench
