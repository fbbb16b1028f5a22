#include "reference/scrambled_points.hpp"

#include "core/random.hpp"

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

/// Each bit is flipped or not by a hash of the bits above it. Multiplying by even numbers lets lower bits depend on
/// higher ones only once the order of bits is reversed.
std::uint32_t owen_scramble(std::uint32_t bits, std::uint32_t seed) {
    std::uint32_t x = reverse_bits(bits);
    x += seed;
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

}  // namespace

glm::dvec2 scrambled_sobol_point(std::uint32_t index, std::uint64_t seed) {
    const std::uint64_t seeds = mix_bits(seed);
    return {to_unit(owen_scramble(reverse_bits(index), static_cast<std::uint32_t>(seeds))),
            to_unit(owen_scramble(second_coordinate(index), static_cast<std::uint32_t>(seeds >> 32)))};
}

}  // namespace reliefbench
