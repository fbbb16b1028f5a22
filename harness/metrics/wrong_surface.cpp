#include "metrics/wrong_surface.hpp"

#include <cassert>
#include <cstddef>

namespace reliefbench {

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

}  // namespace reliefbench
