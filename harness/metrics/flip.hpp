#pragma once

#include "scene/image.hpp"

#include <array>

namespace reliefbench {

/// What the viewer sees of a pixel: 0.7 m from a display of 0.7 m and 3840 pixels width, as published.
constexpr double flip_pixels_per_degree = 67.0206;

/// How many pixels to each side the filters of a pixel's difference reach.
int flip_reach(double pixels_per_degree = flip_pixels_per_degree);

/// The FLIP difference of each pixel, from 0 (none) to 1, for images of low dynamic range: Andersson, Nilsson,
/// Akenine-Möller, Oskarsson, Åström and Fairchild, FLIP: A Difference Evaluator for Alternating Images, 2020.
/// Linear RGB of equal size; values outside [0, 1], which no display shows, are clamped. Symmetric in its images.
Image<float> flip_map(const Image<std::array<float, 3>>& first, const Image<std::array<float, 3>>& second,
                      double pixels_per_degree = flip_pixels_per_degree);

}  // namespace reliefbench
