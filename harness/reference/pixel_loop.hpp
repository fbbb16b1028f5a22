#pragma once

#include "core/parallel.hpp"
#include "scene/image.hpp"
#include "scene/pixel_place.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <span>

namespace reliefbench {

/// Calls body(i, j) for every pixel, rows in parallel.
template <typename Body>
void for_each_pixel(Resolution resolution, const Body& body) {
    constexpr std::size_t rows_per_task = 4;
    parallel_for(static_cast<std::size_t>(resolution.height), rows_per_task, [&](std::size_t begin, std::size_t end) {
        for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j) {
            for (int i = 0; i < resolution.width; ++i)
                body(i, j);
        }
    });
}

/// Calls body(pixels) for tiles of 16 × 16 pixels, cut short by the picture, in parallel. Within a tile 4 × 4 pixels
/// follow each other: the order in which ExactTracer takes rays best.
template <typename Body>
void for_each_pixel_tile(Resolution resolution, const Body& body) {
    constexpr int side = 16;
    constexpr int block = 4;
    const auto tiles_along = [](int pixels) { return (static_cast<std::size_t>(pixels) + side - 1) / side; };
    const std::size_t columns = tiles_along(resolution.width);
    parallel_for(columns * tiles_along(resolution.height), 1, [&](std::size_t begin, std::size_t end) {
        std::array<PixelPlace, side * side> pixels;
        for (std::size_t tile = begin; tile < end; ++tile) {
            const int left = static_cast<int>(tile % columns) * side;
            const int top = static_cast<int>(tile / columns) * side;
            std::size_t count = 0;
            for (int index = 0; index < side * side; ++index) {
                const int of_block = index % (block * block);
                const int which = index / (block * block);
                const int i = left + which % (side / block) * block + of_block % block;
                const int j = top + which / (side / block) * block + of_block / block;
                if (i < resolution.width && j < resolution.height) pixels[count++] = {i, j};
            }
            body(std::span<const PixelPlace>(pixels.data(), count));
        }
    });
}

inline double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace reliefbench
