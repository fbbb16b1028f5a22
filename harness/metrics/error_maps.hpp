#pragma once

#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/image.hpp"
#include "scene/relief.hpp"

namespace reliefbench {

/// Errors of each pixel (pixel_errors.hpp); not a number where not both hit. Images of equal size.

/// Texels.
Image<float> uv_error_map(const HitImage& technique, const HitImage& truth, const HeightMap& map, const Relief& relief);

/// Units of the patch's width, positive = too deep.
Image<float> depth_error_map(const HitImage& technique, const HitImage& truth);

/// Degrees between the shading normals.
Image<float> normal_error_map(const HitImage& technique, const HitImage& truth, const HeightMap& map,
                              const Relief& relief);

}  // namespace reliefbench
