#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace reliefbench {

/// Point `index` of the two-dimensional Sobol sequence in base 2 (Sobol' 1967; its second generator matrix as in Kollig
/// & Keller, Efficient Multidimensional Sampling, 2002), in [0, 1)², with a nested uniform (Owen) scrambling of each
/// coordinate by the hash of Laine & Karras 2011 with the constants of Burley, Practical Hash-based Owen Scrambling,
/// 2020. Every scrambling keeps the stratification of every 2^k first points; those of different seeds are independent.
glm::dvec2 scrambled_sobol_point(std::uint32_t index, std::uint64_t seed);

}  // namespace reliefbench
