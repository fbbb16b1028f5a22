#pragma once

#include "core/figure.hpp"
#include "core/statistics.hpp"
#include "scene/image.hpp"
#include "scene/pixel_work.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace reliefbench {

/// Per covered pixel.
struct WorkSummary {
    /// Of the fragments; taps and texels of vertex and tessellation stages are spread evenly over the covered pixels.
    Summary taps, texels, steps;
    double stage_taps = 0, stage_texels = 0;
    /// Fraction of covered pixels.
    double unconverged = 0;
    std::size_t covered_pixels = 0;
    /// Of self-shadowing, which the others leave out. Empty without it.
    std::optional<Summary> shadow_taps = {};

    /// Of all stages.
    double taps_mean() const { return taps.mean + stage_taps; }
    double taps_p95() const { return taps.p95 + stage_taps; }
    double texels_mean() const { return texels.mean + stage_texels; }
};

/// Empty when nothing is covered. Images of equal size; `stages` are the sums of the stages before fragments;
/// `shadow_taps` may be null: without self-shadowing.
std::optional<WorkSummary> summarize_work(const Image<std::uint8_t>& covered, const Image<PixelWork>& work,
                                          const PixelWork& stages, const Image<std::uint32_t>* shadow_taps);

std::vector<FigureDeclaration> work_figures();
FigureValueList figures_of(const WorkSummary& work);

}  // namespace reliefbench
