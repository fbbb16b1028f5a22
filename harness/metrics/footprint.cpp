#include "metrics/footprint.hpp"

#include <cassert>
#include <cstddef>

namespace reliefbench {

bool is_background_outside(const Image<std::array<float, 3>>& picture, const Footprint& footprint) {
    assert(picture.size == footprint.inside.size);
    for (std::size_t pixel = 0; pixel < picture.texels.size(); ++pixel) {
        if (footprint.inside.texels[pixel] == 0 && picture.texels[pixel] != footprint.background) return false;
    }
    return true;
}

void set_background_outside(Image<std::array<float, 3>>& picture, const Footprint& footprint) {
    assert(picture.size == footprint.inside.size);
    for (std::size_t pixel = 0; pixel < picture.texels.size(); ++pixel) {
        if (footprint.inside.texels[pixel] == 0) picture.texels[pixel] = footprint.background;
    }
}

}  // namespace reliefbench
