#include "reference/scrambled_points.hpp"

#include "core/random.hpp"

#include <bit>
#include <cassert>
#include <cstddef>

namespace reliefbench {

namespace {

std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ffU) << 8) | ((x & 0xff00ff00U) >> 8);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x & 0xf0f0f0f0U) >> 4);
    x = ((x & 0x33333333U) << 2) | ((x & 0xccccccccU) >> 2);
    return ((x & 0x55555555U) << 1) | ((x & 0xaaaaaaaaU) >> 1);
}

/// The second coordinate's bits, the most significant one first: the columns of its matrix are those of Pascal's
/// triangle modulo 2, each the one before xor itself shifted by one.
std::uint32_t second_coordinate(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 0x80000000U; index != 0; index >>= 1, column ^= column >> 1) {
        if ((index & 1) != 0) result ^= column;
    }
    return result;
}

/// Each bit is flipped or not by a hash of the bits above it, which the reversed order has below it. Multiplying by
/// even numbers lets higher bits depend on lower ones only.
std::uint32_t owen_scramble_reversed(std::uint32_t reversed, std::uint32_t seed) {
    std::uint32_t x = reversed + seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reverse_bits(x);
}

double to_unit(std::uint32_t bits) {
    constexpr double scale = 1.0 / 4294967296.0;
    return bits * scale;
}

/// Of a point whose coordinates' bits are reversed; the first coordinate's are the index.
glm::dvec2 scrambled(std::uint32_t index, std::uint32_t reversed_second, std::uint64_t seeds) {
    return {to_unit(owen_scramble_reversed(index, static_cast<std::uint32_t>(seeds))),
            to_unit(owen_scramble_reversed(reversed_second, static_cast<std::uint32_t>(seeds >> 32)))};
}

}  // namespace

glm::dvec2 scrambled_sobol_point(std::uint32_t index, std::uint64_t seed) {
    return scrambled(index, reverse_bits(second_coordinate(index)), mix_bits(seed));
}

std::uint32_t scrambled_index(std::uint32_t index, std::uint32_t count, std::uint64_t seed) {
    assert(std::has_single_bit(count) && index < count);
    if (count == 1) return 0;
    const int unused = std::countl_zero(count) + 1;
    const std::uint32_t reversed = reverse_bits(index << unused);
    return owen_scramble_reversed(reversed, static_cast<std::uint32_t>(mix_bits(seed))) >> unused;
}

ScrambledPoints::ScrambledPoints(std::uint32_t count) : reversed_seconds_(count) {
    for (std::uint32_t index = 0; index < count; ++index)
        reversed_seconds_[index] = reverse_bits(second_coordinate(index));
}

void ScrambledPoints::fill(std::uint64_t seed, std::span<glm::dvec2> points) const {
    assert(points.size() <= reversed_seconds_.size());
    const std::uint64_t seeds = mix_bits(seed);
    for (std::size_t index = 0; index < points.size(); ++index)
        points[index] = scrambled(static_cast<std::uint32_t>(index), reversed_seconds_[index], seeds);
}

glm::dvec2 ScrambledPoints::at(std::uint32_t index, std::uint64_t seed) const {
    return scrambled(index, reversed_seconds_[index], mix_bits(seed));
}

}  // namespace reliefbench
