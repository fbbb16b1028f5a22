#pragma once

#include "scene/image.hpp"

#include <array>
#include <cmath>

namespace reliefbench {

/// Waves and chequers, shifted a little from one another. Linear RGB.
struct Patterns {
    Image<std::array<float, 3>> first{Resolution{40, 30}};
    Image<std::array<float, 3>> second{Resolution{40, 30}};

    Patterns() {
        for (int y = 0; y < first.size.height; ++y) {
            for (int x = 0; x < first.size.width; ++x) {
                first.at(x, y) = {static_cast<float>(0.5 + 0.5 * std::sin(0.4 * x)),
                                  static_cast<float>(0.5 + 0.5 * std::sin(0.3 * y)),
                                  static_cast<float>((x / 7 + y / 5) % 2)};
                second.at(x, y) = {static_cast<float>(0.5 + 0.5 * std::sin(0.4 * x + 0.5)),
                                   static_cast<float>(0.5 + 0.45 * std::sin(0.3 * y + 0.2)),
                                   static_cast<float>(0.8 * ((x / 7 + (y + 1) / 5) % 2))};
            }
        }
    }
};

}  // namespace reliefbench
