#pragma once

#include "core/random.hpp"

#include <cmath>
#include <numbers>

namespace reliefbench {

/// A draw from the standard normal distribution (Box & Muller 1958), the same on every machine up to rounding.
inline double standard_normal(Random& random) {
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

}  // namespace reliefbench
