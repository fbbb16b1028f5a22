#include "metrics/raster_mismatch.hpp"

#include <cassert>
#include <cstddef>
#include <optional>
#include <string>

namespace reliefbench {

namespace {

const std::vector<FigureOf<double>>& raster_mismatch_table() {
    static const std::vector<FigureOf<double>> table = {
        {{.path = "error.raster_mismatch",
          .label = "Rasteriser and ray disagree on the base",
          .unit = "fraction of footprint",
          .needs = {std::string(figure_needs::truth)}},
         [](const double& fraction) { return std::optional(fraction); }},
    };
    return table;
}

}  // namespace

double raster_mismatch(const Image<std::uint8_t>& covered, const FootprintImage& footprint) {
    assert(covered.size == footprint.size);
    std::size_t inside = 0;
    std::size_t differing = 0;
    for (std::size_t pixel = 0; pixel < footprint.texels.size(); ++pixel) {
        const bool is_inside = footprint.texels[pixel] != 0;
        inside += is_inside ? 1 : 0;
        differing += is_inside != (covered.texels[pixel] != 0) ? 1 : 0;
    }
    return inside == 0 ? 0 : static_cast<double>(differing) / static_cast<double>(inside);
}

std::vector<FigureDeclaration> raster_mismatch_figures() {
    return declarations_in(raster_mismatch_table());
}

FigureValueList figures_of_raster_mismatch(double fraction) {
    return values_in(raster_mismatch_table(), fraction);
}

}  // namespace reliefbench
