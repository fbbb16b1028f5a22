#pragma once

#include "core/figure.hpp"
#include "metrics/compared_hits.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace reliefbench {

/// How far apart the outlines of what a technique and the truth hit are. A pixel is on the outline of a set of pixels
/// within a region where it is of the set and one of its four neighbours is of the region and not of the set; holes
/// have outlines, too.
struct OutlineErrors {
    struct Distances {
        /// In pixels, between pixel centres, from each outline pixel of either set to the nearest one of the other; of
        /// both ways together. Empty where there are no such pixels, and where one set has nothing to compare them
        /// with.
        std::optional<double> mean, p95;
        /// Outline pixels that distances are taken from.
        std::size_t pixels = 0;
    };
    /// Of the sets within F. Where a set ends because F or the frame does is no outline, and no distance is taken from
    /// there. But where the other set ends before, it is what the other's outline is compared with.
    Distances footprint;
    /// Over the whole frame; empty where the truth ends with F.
    std::optional<Distances> whole;
};

/// In ties the technique counts as right, and no distance is taken from them.
OutlineErrors compare_outlines(const ComparedHits& hits);

std::vector<FigureDeclaration> outline_error_figures();
FigureValueList figures_of(const OutlineErrors& errors);

}  // namespace reliefbench
