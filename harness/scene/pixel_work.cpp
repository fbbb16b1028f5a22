#include "scene/pixel_work.hpp"

#include <cassert>
#include <cstddef>

namespace reliefbench {

double unconverged_fraction(const Image<std::uint8_t>& covered, const Image<PixelWork>& work) {
    assert(covered.size == work.size);
    std::size_t pixels = 0;
    std::size_t unconverged = 0;
    for (std::size_t pixel = 0; pixel < covered.texels.size(); ++pixel) {
        if (covered.texels[pixel] == 0) continue;
        ++pixels;
        if (work.texels[pixel].unconverged > 0) ++unconverged;
    }
    return pixels == 0 ? 0 : static_cast<double>(unconverged) / static_cast<double>(pixels);
}

}  // namespace reliefbench
