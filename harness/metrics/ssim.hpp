#pragma once

#include "scene/image.hpp"

namespace reliefbench {

/// How many pixels to each side the window of a pixel's similarity reaches.
constexpr int ssim_reach = 5;

/// The structural similarity around each pixel, 1 for equal surroundings: Wang, Bovik, Sheikh and Simoncelli, Image
/// Quality Assessment: From Error Visibility to Structural Similarity, 2004, with their Gaussian window of 11×11 and
/// σ = 1.5, K₁ = 0.01, K₂ = 0.03, and population covariances. Values in [0, 1], images of equal size. The image
/// is mirrored beyond its border (its outermost texels twice).
Image<double> ssim_map(const Image<double>& first, const Image<double>& second);

}  // namespace reliefbench
