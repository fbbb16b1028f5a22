#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace reliefbench {

/// Point `index` of the two-dimensional Sobol sequence in base 2 (Sobol' 1967; its second generator matrix as in Kollig
/// & Keller, Efficient Multidimensional Sampling, 2002), in [0, 1)², with a nested uniform (Owen) scrambling of each
/// coordinate by the hash of Laine & Karras 2011 with the constants of Burley, Practical Hash-based Owen Scrambling,
/// 2020. Every scrambling keeps the stratification of every 2^k first points; those of different seeds are independent.
glm::dvec2 scrambled_sobol_point(std::uint32_t index, std::uint64_t seed);

/// A permutation of the first `count` numbers, a power of two, that leaves those of each aligned 2^k together: where
/// points of one scrambling are taken in the order of another, both stay stratified and nothing of them is correlated.
std::uint32_t scrambled_index(std::uint32_t index, std::uint32_t count, std::uint64_t seed);

/// The same points, quicker than one by one where many scramblings of the first few are wanted.
class ScrambledPoints {
public:
    explicit ScrambledPoints(std::uint32_t count);

    /// scrambled_sobol_point(i, seed) for each i.
    void fill(std::uint64_t seed, std::span<glm::dvec2> points) const;
    /// scrambled_sobol_point(index, seed).
    glm::dvec2 at(std::uint32_t index, std::uint64_t seed) const;

private:
    /// Of the second coordinates, the least significant bit first.
    std::vector<std::uint32_t> reversed_seconds_;
};

}  // namespace reliefbench
