#pragma once

#include "core/figure.hpp"
#include "metrics/compared_hits.hpp"
#include "scene/image.hpp"
#include "scene/lighting.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace reliefbench {

/// How much of each light reaches each pixel's hit, by light; in [0, 1].
using VisibilityImage = Image<std::array<float, 3>>;

/// Of how much light a technique's shadows let through, against the truth's. Over the pixels of the footprint, but
/// ties, in which both hit, and in each over the lights that the truth's shading normal faces: on others a shadow is
/// not seen.
struct ShadowErrors {
    /// Mean of |visibility − true visibility|.
    double mean = 0;
    /// Fractions of what is compared: darker or lighter than the truth by half of the light or more.
    double false_shadow = 0;
    double missed_shadow = 0;
    /// Pixels and lights compared; without any, all errors are 0.
    std::size_t compared = 0;
    /// Of the truth's soft shadows, averaged over their penumbrae, for whoever traced them to set; empty for hard ones.
    std::optional<double> truth_standard_error = {};
};

/// Images of the hits' size.
ShadowErrors compare_shadows(const VisibilityImage& technique, const VisibilityImage& truth, const ComparedHits& hits,
                             const Lighting& lighting);

std::vector<FigureDeclaration> shadow_error_figures();
FigureValueList figures_of(const ShadowErrors& errors);

}  // namespace reliefbench
