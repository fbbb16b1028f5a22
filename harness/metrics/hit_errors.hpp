#pragma once

#include "core/figure.hpp"
#include "core/statistics.hpp"
#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/relief.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace reliefbench {

/// Errors of a technique's hits against the truth's, as docs/architecture.md defines them.
struct HitErrors {
    /// Over the pixels of the footprint in which both hit, ties left out; empty when there is none.
    std::optional<Summary> uv_texels;
    /// t − t_truth, positive = too deep: `mean` is signed, every other statistic is of the magnitude.
    std::optional<Summary> depth;
    /// Angle between the shading normals, degrees.
    std::optional<Summary> normal_deg;
    /// What these are of: each pixel compared, in the order of the image; depth signed.
    struct ComparedPixels {
        std::vector<double> uv_texels, depth, normal_deg;
    };
    ComparedPixels pixels;
    /// Pixels compared.
    std::size_t compared = 0;
    /// Pixels of the footprint F.
    std::size_t footprint = 0;
    /// Fractions of F: truth hits and technique does not; technique hits and truth does not. 0 when F is empty. Ties
    /// are neither.
    double missed = 0;
    double false_hits = 0;
    /// Fraction of F that the truth marks as ties, which take no part in any other figure here.
    double ties = 0;
    /// Truth hits outside F (only real geometry can draw them): how many, and the fraction of them that the technique
    /// covers. `covered` is empty when there are none.
    std::size_t outside_quad_pixels = 0;
    std::optional<double> outside_quad_covered;
    /// Intersection over union of the covered pixels; 1 when both are empty. Over the whole image, or over the
    /// footprint for Boundary::repeat, whose truth ends there.
    double coverage_iou = 1;
};

/// A technique's hit with a number that is not finite (a shader's division by zero) counts as a miss.
HitErrors compare_hits(const HitImage& technique, const HitImage& truth, const FootprintImage& footprint,
                       const HeightMap& map, const Relief& relief);

std::vector<FigureDeclaration> hit_error_figures();
FigureValueList figures_of(const HitErrors& errors);

}  // namespace reliefbench
