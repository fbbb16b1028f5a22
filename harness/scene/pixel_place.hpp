#pragma once

#include "scene/image.hpp"

#include <cstddef>

namespace reliefbench {

/// A pixel of a picture, from its top left corner, both from 0.
struct PixelPlace {
    int column = 0;
    int row = 0;

    bool operator==(const PixelPlace&) const = default;
};

/// Of a pixel's index, row by row.
inline PixelPlace place_of(std::size_t pixel, Resolution size) {
    const auto width = static_cast<std::size_t>(size.width);
    return {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
}

}  // namespace reliefbench
