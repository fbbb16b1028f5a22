#pragma once

#include "scene/hit.hpp"
#include "scene/image.hpp"

#include <array>
#include <optional>

namespace reliefbench {

/// Over the union of both coverages, on sRGB-encoded values in [0, 1] (FLIP takes linear ones to its own space).
struct ImageErrors {
    /// Root mean square over pixels and channels; empty when nothing is covered.
    std::optional<double> rmse;
    /// Decibels, peak 1; empty for identical images (rmse 0) or no coverage.
    std::optional<double> psnr;
    /// Mean structural similarity over pixels and channels; its window reaches beyond the union.
    std::optional<double> ssim;
    /// Mean FLIP difference over pixels.
    std::optional<double> flip;
};

/// Linear RGB images of equal size; `technique_hits` and `truth_hits` give the coverage.
ImageErrors compare_images(const Image<std::array<float, 3>>& technique, const HitImage& technique_hits,
                           const Image<std::array<float, 3>>& truth, const HitImage& truth_hits);

/// The structural similarity around each pixel: the mean of the three sRGB-encoded channels. Linear RGB.
Image<float> colour_ssim_map(const Image<std::array<float, 3>>& first, const Image<std::array<float, 3>>& second);

}  // namespace reliefbench
