#include "metrics/window.hpp"

#include <algorithm>

namespace reliefbench {

Window window_around(const Image<std::uint8_t>& mask, int reach) {
    int left = mask.size.width, right = -1, top = mask.size.height, bottom = -1;
    for (int y = 0; y < mask.size.height; ++y) {
        for (int x = 0; x < mask.size.width; ++x) {
            if (mask.at(x, y) == 0) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = y;
        }
    }
    if (right < 0) return {};
    left = std::max(0, left - reach);
    top = std::max(0, top - reach);
    right = std::min(mask.size.width - 1, right + reach);
    bottom = std::min(mask.size.height - 1, bottom + reach);
    return {left, top, {right - left + 1, bottom - top + 1}};
}

}  // namespace reliefbench
