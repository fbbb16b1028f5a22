#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace reliefbench {

/// Elementary functions of floats, inlined and without branches, so that loops over pixels are vectorised: calls of
/// the C library's took most of an image metric's time. Each is accurate to a few units in the last place.

/// The cube root of a normal t > 0.
inline float cube_root(float t) {
    // An exponent divided by three, with the offset that makes the error of the guess least (Kahan, 1991).
    constexpr std::uint32_t offset = 709958130;
    auto root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(t) / 3 + offset);
    for (int halley = 0; halley < 2; ++halley) {
        const float cube = root * root * root;
        root *= (cube + 2 * t) / (2 * cube + t);
    }
    return root;
}

/// The logarithm to base 2 of a normal x > 0.
inline float log_2(float x) {
    constexpr std::int32_t sqrt_half = std::bit_cast<std::int32_t>(std::numbers::sqrt2_v<float> / 2);
    constexpr int mantissa_bits = std::numeric_limits<float>::digits - 1;
    const auto bits = std::bit_cast<std::int32_t>(x);
    // x = 2^exponent · mantissa, the mantissa in [√½, √2).
    const std::int32_t exponent = (bits - sqrt_half) >> mantissa_bits;
    const auto mantissa = std::bit_cast<float>(bits - (exponent << mantissa_bits));
    // log m = 2 artanh((m − 1) / (m + 1)), as a series; the first term left out is below 1e-9.
    const float s = (mantissa - 1) / (mantissa + 1);
    const float s2 = s * s;
    const float series = s * (1 + s2 * (1.0F / 3 + s2 * (1.0F / 5 + s2 * (1.0F / 7 + s2 / 9))));
    return static_cast<float>(exponent) + 2 * std::numbers::log2e_v<float> * series;
}

/// 2^x for x in [−126, 127].
inline float exp_2(float x) {
    constexpr int mantissa_bits = std::numeric_limits<float>::digits - 1;
    const auto whole = static_cast<std::int32_t>(x + std::copysign(0.5F, x));
    // The series of exp(f) for |f| ≤ ln 2 / 2; the first term left out is below 6e-9.
    const float f = (x - static_cast<float>(whole)) * std::numbers::ln2_v<float>;
    const float series = 1 + f * (1 + f / 2 * (1 + f / 3 * (1 + f / 4 * (1 + f / 5 * (1 + f / 6 * (1 + f / 7))))));
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(series) + (whole << mantissa_bits));
}

/// x^y for x ≥ 0 and 0 ≤ y ≤ 1, with 0^0 = 1; a denormal x counts as 0.
inline float power(float x, float y) {
    constexpr float smallest = std::numeric_limits<float>::min();
    const float positive = exp_2(y * log_2(x < smallest ? smallest : x));
    const float of_zero = y > 0 ? 0.0F : 1.0F;
    return x < smallest ? of_zero : positive;
}

}  // namespace reliefbench
