#pragma once

#include "core/figure.hpp"
#include "metrics/footprint.hpp"
#include "metrics/motion_errors.hpp"

#include <array>
#include <optional>
#include <vector>

namespace reliefbench {

/// A frame as a history shows it, and as it would look if the camera stood still there for long. Linear RGB.
struct ResolvedFrame {
    const Image<std::array<float, 3>>& history;
    const Image<std::array<float, 3>>& still;
};

/// What the history shows of other frames: FLIP between both pictures in the pixels of F, with the background outside F
/// in both.
std::vector<double> ghosting(const ResolvedFrame& frame, const Footprint& footprint);

/// How a history's error (history − still) changes between two frames beside what moves with the surface: FLIP between
/// the first history and the first still picture with the second frame's errors, in the pixels whose points are seen in
/// both. Those errors are interpolated where the points land, so that one that does not change gives 0; no picture is
/// resampled.
std::vector<double> history_flip(const Image<Landing>& landings, const ResolvedFrame& first,
                                 const ResolvedFrame& second);

/// Over the frames but the first, and over the pairs of neighbouring frames.
struct HistoryErrors {
    std::optional<MotionFigures::Values> ghosting, flip;
};

std::vector<FigureDeclaration> history_figures();
FigureValueList figures_of(const HistoryErrors& errors);

}  // namespace reliefbench
