#pragma once

#include "core/figure.hpp"
#include "metrics/footprint.hpp"
#include "scene/image.hpp"

#include <array>
#include <optional>
#include <vector>

namespace reliefbench {

/// How much of a truth's picture, the mean of several samples a pixel, is noise. Over F; all are empty where that is.
struct TruthNoise {
    /// Over pixels, of each one's standard error, in linear light. The root of the mean square is right on average; the
    /// mean is less, by a fifth where noise is Gaussian, as each pixel's is known from two means only.
    std::optional<double> mean;
    std::optional<double> rms;
    std::optional<double> p99;
    /// Mean FLIP of the picture of half the samples, which differs from the picture by as much as that does from
    /// infinitely many samples: about what a technique has that draws exactly this limit.
    std::optional<double> flip;
};

/// `standard_error` by pixel; `half_picture` is the mean over one of two scramblings, `picture` over both. Linear RGB.
TruthNoise truth_noise(const Image<float>& standard_error, const Image<std::array<float, 3>>& half_picture,
                       const Image<std::array<float, 3>>& picture, const Footprint& footprint);

std::vector<FigureDeclaration> truth_noise_figures();
FigureValueList figures_of(const TruthNoise& noise);

}  // namespace reliefbench
