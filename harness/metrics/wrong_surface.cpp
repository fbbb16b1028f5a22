#include "metrics/wrong_surface.hpp"

#include <cassert>
#include <cstddef>
#include <optional>
#include <string>

namespace reliefbench {

namespace {

const std::vector<FigureOf<double>>& wrong_surface_table() {
    static const std::vector<FigureOf<double>> table = {
        {{.path = "error.wrong_surface",
          .label = "Wrong one of relief and object in front",
          .unit = "fraction of footprint",
          .better = Better::lower,
          .needs = {std::string(figure_needs::truth), std::string(figure_needs::object)}},
         [](const double& fraction) { return std::optional(fraction); }},
    };
    return table;
}

}  // namespace

double wrong_surface(const Image<Front>& technique, const Image<Front>& truth, const FootprintImage& footprint) {
    assert(technique.size == truth.size && footprint.size == truth.size);
    std::size_t pixels = 0;
    std::size_t wrong = 0;
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        if (footprint.texels[pixel] != in_footprint) continue;
        ++pixels;
        const bool shows_object = technique.texels[pixel] == Front::object;
        wrong += shows_object != (truth.texels[pixel] == Front::object) ? 1 : 0;
    }
    return pixels == 0 ? 0 : static_cast<double>(wrong) / static_cast<double>(pixels);
}

std::vector<FigureDeclaration> wrong_surface_figures() {
    return declarations_in(wrong_surface_table());
}

FigureValueList figures_of_wrong_surface(double fraction) {
    return values_in(wrong_surface_table(), fraction);
}

}  // namespace reliefbench
