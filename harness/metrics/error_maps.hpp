#pragma once

#include "metrics/compared_hits.hpp"
#include "scene/image.hpp"

namespace reliefbench {

/// Errors of each pixel (pixel_errors.hpp); not a number where not both hit.

/// Texels; not a number, too, where coordinates do not tell (ComparedHits::is_off_chart).
Image<float> uv_error_map(const ComparedHits& hits);

/// Units of the patch's width, positive = too deep.
Image<float> depth_error_map(const ComparedHits& hits);

/// Degrees between the shading normals.
Image<float> normal_error_map(const ComparedHits& hits);

}  // namespace reliefbench
