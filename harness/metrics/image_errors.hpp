#pragma once

#include "core/figure.hpp"
#include "metrics/footprint.hpp"
#include "scene/hit.hpp"
#include "scene/image.hpp"

#include <array>
#include <optional>
#include <vector>

namespace reliefbench {

/// Over some pixels, on sRGB-encoded values in [0, 1] (FLIP takes linear ones to its own space). All are empty where
/// there is no pixel.
struct ImageErrors {
    /// Root mean square over pixels and channels.
    std::optional<double> rmse;
    /// Decibels, peak 1; empty for identical images, too (rmse 0).
    std::optional<double> psnr;
    /// Mean structural similarity over pixels and channels; its window reaches beyond the pixels.
    std::optional<double> ssim;
    /// Mean FLIP difference over pixels; its filters reach beyond them.
    std::optional<double> flip;
};

struct ImageComparison {
    /// Over the union of both coverages. The relief that a truth shows outside F counts, which no technique that
    /// draws the base alone can show: a floor, and not a small one (0.1 FLIP at 70°).
    ImageErrors whole;
    /// Over F, of both pictures with the background outside F before anything is filtered: what a technique can help.
    ImageErrors footprint;
};

/// Linear RGB images of equal size; `technique_hits` and `truth_hits` give the coverage.
ImageComparison compare_images(const Image<std::array<float, 3>>& technique, const HitImage& technique_hits,
                               const Image<std::array<float, 3>>& truth, const HitImage& truth_hits,
                               const Footprint& footprint);

std::vector<FigureDeclaration> image_error_figures();
FigureValueList figures_of(const ImageComparison& comparison);

/// What FLIP and SSIM (the mean of the three encoded channels) of ImageComparison::footprint are means of; not a number
/// outside F. Linear RGB.
Image<float> footprint_flip_map(const Image<std::array<float, 3>>& technique, const Image<std::array<float, 3>>& truth,
                                const Footprint& footprint);
Image<float> footprint_ssim_map(const Image<std::array<float, 3>>& technique, const Image<std::array<float, 3>>& truth,
                                const Footprint& footprint);

}  // namespace reliefbench
