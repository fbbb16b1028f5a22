#pragma once

#include "metrics/vector_math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace reliefbench::flip {

/// Colour spaces and differences of FLIP (Andersson et al. 2020), by the paper's symbols. Inline: each is called for
/// every pixel from loops that are vectorised.

using Rgb = std::array<float, 3>;

/// The linearised opponent space of the filters.
struct YCxCz {
    float y, cx, cz;
};

struct Lab {
    float l, a, b;
};

namespace detail {

constexpr float ratio(double numerator, double denominator) {
    return static_cast<float>(numerator / denominator);
}

using Matrix = std::array<std::array<float, 3>, 3>;

/// CIE XYZ of the sRGB primaries at D65.
constexpr Matrix rgb_to_xyz{{{ratio(10135552, 24577794), ratio(8788810, 24577794), ratio(4435075, 24577794)},
                             {ratio(2613072, 12288897), ratio(8788810, 12288897), ratio(887015, 12288897)},
                             {ratio(1425312, 73733382), ratio(8788810, 73733382), ratio(70074185, 73733382)}}};

/// Its rows divided by the white point's X, Y and Z.
constexpr Matrix make_rgb_to_relative_xyz() {
    Matrix relative = rgb_to_xyz;
    for (std::array<float, 3>& row : relative) {
        const float white = row[0] + row[1] + row[2];
        for (float& value : row) {
            value /= white;
        }
    }
    return relative;
}
constexpr Matrix rgb_to_relative_xyz = make_rgb_to_relative_xyz();

constexpr double determinant_2(double a, double b, double c, double d) {
    return a * d - b * c;
}

/// By cofactors.
constexpr Matrix inverse(const Matrix& m) {
    std::array<std::array<double, 3>, 3> cofactors{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const std::size_t r1 = (row + 1) % 3, r2 = (row + 2) % 3;
            const std::size_t c1 = (column + 1) % 3, c2 = (column + 2) % 3;
            cofactors[row][column] = determinant_2(m[r1][c1], m[r1][c2], m[r2][c1], m[r2][c2]);
        }
    }
    double determinant = 0;
    for (std::size_t column = 0; column < 3; ++column) {
        determinant += static_cast<double>(m[0][column]) * cofactors[0][column];
    }
    Matrix result{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            result[row][column] = static_cast<float>(cofactors[column][row] / determinant);
        }
    }
    return result;
}
constexpr Matrix relative_xyz_to_rgb = inverse(rgb_to_relative_xyz);

inline std::array<float, 3> product(const Matrix& matrix, const std::array<float, 3>& vector) {
    std::array<float, 3> result{};
    for (std::size_t row = 0; row < 3; ++row) {
        result[row] = matrix[row][0] * vector[0] + matrix[row][1] * vector[1] + matrix[row][2] * vector[2];
    }
    return result;
}

/// CIE 1976's f: the cube root, and a line near 0.
inline float lab_curve(float t) {
    constexpr float delta = 6.0F / 29;
    constexpr float knee = delta * delta * delta;
    const float line = t * (1 / (3 * delta * delta)) + 4.0F / 29;
    const float root = cube_root(std::max(t, knee));
    return t > knee ? root : line;
}

}  // namespace detail

/// What no display shows is clamped.
inline Rgb clamped(const Rgb& colour) {
    return {std::clamp(colour[0], 0.0F, 1.0F), std::clamp(colour[1], 0.0F, 1.0F), std::clamp(colour[2], 0.0F, 1.0F)};
}

inline YCxCz to_ycxcz(const Rgb& linear) {
    const auto [x, y, z] = detail::product(detail::rgb_to_relative_xyz, linear);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

inline Rgb to_linear(const YCxCz& colour) {
    const float y = (colour.y + 16) * (1.0F / 116);
    return detail::product(detail::relative_xyz_to_rgb,
                           {y + colour.cx * (1.0F / 500), y, y - colour.cz * (1.0F / 200)});
}

/// CIE 1976 L*a*b* with chroma scaled by lightness (the Hunt effect).
inline Lab to_hunt_adjusted_lab(const Rgb& linear) {
    const auto [x, y, z] = detail::product(detail::rgb_to_relative_xyz, linear);
    const float f_y = detail::lab_curve(y);
    const float lightness = 116 * f_y - 16;
    const float hunt = 0.01F * lightness;
    return {lightness, hunt * 500 * (detail::lab_curve(x) - f_y), hunt * 200 * (f_y - detail::lab_curve(z))};
}

/// Abasi, Amani Tehran and Fairchild 2019: city-block in lightness, Euclidean in chroma.
inline float hyab(const Lab& first, const Lab& second) {
    const float a = first.a - second.a;
    const float b = first.b - second.b;
    return std::abs(first.l - second.l) + std::sqrt(a * a + b * b);
}

inline float compressed_hyab(const Lab& first, const Lab& second) {
    constexpr float q_c = 0.7F;
    return power(hyab(first, second), q_c);
}

/// The largest compressed colour difference, between green and blue.
inline float largest_colour_difference() {
    return compressed_hyab(to_hunt_adjusted_lab({0, 1, 0}), to_hunt_adjusted_lab({0, 0, 1}));
}

/// Equation 5's redistribution of the colour difference to [0, 1]; `c_max` is largest_colour_difference().
inline float colour_difference(const Lab& first, const Lab& second, float c_max) {
    constexpr float p_c = 0.4F;
    constexpr float p_t = 0.95F;
    const float difference = compressed_hyab(first, second);
    const float knee = p_c * c_max;
    const float below = p_t / knee * difference;
    const float above = p_t + (difference - knee) * ((1 - p_t) / (c_max - knee));
    return difference < knee ? below : above;
}

}  // namespace reliefbench::flip
