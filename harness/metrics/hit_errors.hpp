#pragma once

#include "core/figure.hpp"
#include "core/statistics.hpp"
#include "metrics/compared_hits.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace reliefbench {

/// Errors of a technique's hits against the truth's, as docs/architecture.md defines them.
struct HitErrors {
    /// Over the pixels of the footprint in which both hit, ties left out, and those off the chart; empty when there is
    /// none.
    std::optional<Summary> uv_texels;
    /// Likewise, with those off the chart.
    /// t − t_truth, positive = too deep: `mean` is signed, every other statistic is of the magnitude.
    std::optional<Summary> depth;
    /// Angle between the shading normals, degrees.
    std::optional<Summary> normal_deg;
    /// What these are of: each pixel, in the order of the image; depth signed.
    struct ComparedPixels {
        std::vector<double> uv_texels, depth, normal_deg;
    };
    ComparedPixels pixels;
    /// Pixels of the footprint in which both hit, ties left out.
    std::size_t compared = 0;
    /// Pixels of the footprint F.
    std::size_t footprint = 0;
    /// Fractions of F: truth hits and technique does not; technique hits and truth does not. 0 when F is empty. Ties
    /// are neither.
    double missed = 0;
    double false_hits = 0;
    /// Fraction of F that the truth marks as ties, which take no part in any other figure here.
    double ties = 0;
    /// Fraction of F: of the pixels compared those that are off the chart (ComparedHits::is_off_chart). Empty where the
    /// base is flat.
    std::optional<double> off_chart = {};
    /// Truth hits outside F (what draws the base alone cannot draw them): how many, and the fraction of them that the
    /// technique covers. `covered` is empty when there are none.
    std::size_t outside_quad_pixels = 0;
    std::optional<double> outside_quad_covered;
    /// Intersection over union of the covered pixels; 1 when both are empty. Over the whole image, or over the
    /// footprint where the truth ends with it (ComparedHits::ends_with_footprint).
    double coverage_iou = 1;
};

/// A technique's hit with a number that is not finite (a shader's division by zero) counts as a miss.
HitErrors compare_hits(const ComparedHits& hits);

std::vector<FigureDeclaration> hit_error_figures();
FigureValueList figures_of(const HitErrors& errors);

}  // namespace reliefbench
