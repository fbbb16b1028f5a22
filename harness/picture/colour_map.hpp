#pragma once

#include <array>

namespace reliefbench {

/// A perceptually uniform colour map for error maps, black to pale yellow by way of purple and orange, as sRGB-encoded
/// values in [0, 1]. `x` is clamped to [0, 1]. Within 0.03 of the map "magma" of Smith and van der Walt (CC0), to which
/// the polynomials were fitted.
std::array<double, 3> magma(double x);

}  // namespace reliefbench
