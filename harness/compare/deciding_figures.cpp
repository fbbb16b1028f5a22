#include "compare/deciding_figures.hpp"

#include "store/chosen_figures.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace reliefbench {

double size_in_tolerances(double a, double b, const FigureTolerance& tolerance) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (a == b) return 0;
    if (std::isinf(a) || std::isinf(b)) return infinity;
    const double difference = std::abs(a - b);
    double size = infinity;
    if (tolerance.absolute > 0) size = std::min(size, difference / tolerance.absolute);
    if (tolerance.relative > 0) {
        size = std::min(size, difference / std::max(std::abs(a), std::abs(b)) / tolerance.relative);
    }
    return size;
}

FigureTolerance tolerance_of(const FigureDeclaration& figure) {
    // Per frame: small beside the errors themselves.
    if (figure.has_need(figure_needs::motion) && !figure.is_count) return {0.005, 0.05};
    // On a scale that ends at 1, where a share of the value says little.
    if (figure.unit.empty() && figure.better == Better::higher) return {0.005, 0};
    if (figure.has_need(figure_needs::lighting) && figure.unit.empty() && !figure.is_count) return {0.002, 0.02};
    if (figure.unit.starts_with("fraction")) return {0.001, 0};
    if (figure.unit == "texels") return {0.05, 0.05};
    if (figure.unit == "degrees") return {0.5, 0.05};
    if (figure.unit == "pixels" && !figure.is_count) return {0.1, 0.05};
    // 0.05 texels of a map of 256.
    if (figure.unit == "patch sides") return {0.0002, 0.05};
    if (figure.unit == "visibility") return {0.005, 0.05};
    if (figure.unit == "dB") return {0.2, 0};
    // Taps, steps, bytes, counts.
    return {0, 0.01};
}

std::string DecidingFigure::name() const {
    std::string text;
    for (const FigureDeclaration* term : terms) {
        if (!text.empty()) text += '+';
        text += term->path;
    }
    return text;
}

DecidingFigure deciding_figure(std::vector<const FigureDeclaration*> terms) {
    assert(!terms.empty());
    DecidingFigure figure;
    figure.tolerance = tolerance_of(*terms.front());
    if (terms.size() == 1 && !terms.front()->stand_in.empty()) figure.stand_in = find_figure(terms.front()->stand_in);
    figure.terms = std::move(terms);
    return figure;
}

const std::vector<DecidingFigure>& default_deciding_figures() {
    using namespace chosen_figures;
    static const std::vector<DecidingFigure> figures = {
        deciding_figure({&known_figure(quality)}),
        deciding_figure({&known_figure(mean_uv)}),
        deciding_figure({&known_figure(missed), &known_figure(false_hits)}),
        deciding_figure({&known_figure(flip)}),
        deciding_figure({&known_figure(shadow)}),
        deciding_figure({&known_figure(motion)}),
        deciding_figure({&known_figure(motion_flip)}),
        deciding_figure({&known_figure(ghosting)}),
        deciding_figure({&known_figure(history_flip)}),
    };
    return figures;
}

}  // namespace reliefbench
