#pragma once

#include "scene/image.hpp"

#include <cstdint>

namespace reliefbench {

/// A part of an image; row 0 is the image's own.
struct Window {
    int left = 0;
    int top = 0;
    Resolution size;
};

/// The smallest window with every pixel of `mask` that is not 0, and `reach` pixels around it where the image has them.
/// Empty where there are none.
Window window_around(const Image<std::uint8_t>& mask, int reach);

template <typename Texel>
Image<Texel> part_of(const Image<Texel>& image, const Window& window) {
    Image<Texel> part(window.size);
    for (int y = 0; y < window.size.height; ++y) {
        for (int x = 0; x < window.size.width; ++x) {
            part.at(x, y) = image.at(window.left + x, window.top + y);
        }
    }
    return part;
}

}  // namespace reliefbench
