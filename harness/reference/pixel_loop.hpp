#pragma once

#include "core/parallel.hpp"
#include "scene/image.hpp"

#include <chrono>
#include <cstddef>

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

inline double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace reliefbench
