#pragma once

#include "store/figures.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// What a figure has to change by to matter: more than both, of which 0 asks for nothing.
struct FigureTolerance {
    /// In the figure's unit.
    double absolute = 0;
    /// Of the larger value, so that A against B is worse where B against A is better.
    double relative = 0;
};

/// How often the difference of two values contains the tolerance: above 1 it matters. Infinite where the tolerance asks
/// for nothing, and for a difference that is infinite.
double size_in_tolerances(double a, double b, const FigureTolerance& tolerance);

/// By the figure's unit: 0.05 texels and 5 % of a UV error, 0.1 % of a fraction, 0.002 and 2 % of an image's error,
/// 0.005 and 5 % of a shadow's error and of those in motion ...
FigureTolerance tolerance_of(const FigureDeclaration& figure);

/// A figure that decides whether quality is better or worse, or the sum of several.
struct DecidingFigure {
    /// At least one; all of one unit and direction.
    std::vector<const FigureDeclaration*> terms;
    FigureTolerance tolerance;
    /// Decides where either side lacks the figure; null for none.
    const FigureDeclaration* stand_in = nullptr;

    /// "error.uv_texels.p99", "error.missed+error.false_hits".
    std::string name() const;
    Better better() const { return terms.front()->better; }
};

/// With the tolerance of its terms. For FLIP over the footprint, and its kin, that over the whole picture stands in.
DecidingFigure deciding_figure(std::vector<const FigureDeclaration*> terms);

/// The 99th percentile and the mean of the UV error, missed and false hits together, FLIP over the footprint, and the
/// means of the errors of shadows and in motion.
const std::vector<DecidingFigure>& default_deciding_figures();

}  // namespace reliefbench
