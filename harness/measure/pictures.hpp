#pragma once

#include "reference/truth.hpp"
#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/image_file.hpp"
#include "scene/relief.hpp"
#include "technique/renderer.hpp"

#include <array>
#include <vector>

namespace reliefbench {

/// Linear RGB encoded to sRGB.
RasterFile display_picture(const Image<std::array<float, 3>>& linear);

/// UV error of each pixel in texels on a logarithmic scale from 0.01 (dark) to 10 (light) in the colours of magma.
/// Blue: missed (truth hits, the technique does not). Cyan: the same outside the footprint, where only real geometry
/// can draw. Green: false hit. Grey: neither hits.
RasterFile error_picture(const HitImage& hits, const Truth& truth, const HeightMap& map, const Relief& relief);

/// The float layers hit.{u,v,h,t}, taps, truth.{u,v,h,t}, color.{R,G,B} and truth_color.{R,G,B}: patch coordinates,
/// linear colours, t = −1 and zeros for a miss. Taps of vertex and tessellation stages are spread over covered pixels.
RasterFile layers(const Probe& probe, const Truth& truth);

/// Pictures of equal height from left to right, parted by a thin line.
RasterFile side_by_side(const std::vector<RasterFile>& pictures);

}  // namespace reliefbench
