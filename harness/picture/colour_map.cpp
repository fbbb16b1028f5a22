#include "picture/colour_map.hpp"

#include <algorithm>
#include <cstddef>

namespace reliefbench {

namespace {

/// Red, green and blue coefficients, constant term first: least squares over 33 points of the published map.
constexpr std::array<std::array<double, 3>, 7> coefficients{{
    {0.00127, 0.00057, 0.01313},
    {0.22874, 0.59554, 1.96211},
    {8.07155, -2.33635, 4.25899},
    {-25.29454, 8.32630, -26.53708},
    {45.85173, -15.31029, 33.82177},
    {-43.78095, 16.66309, -12.22725},
    {15.90983, -6.94811, -0.54210},
}};

}  // namespace

std::array<double, 3> magma(double x) {
    x = std::clamp(x, 0.0, 1.0);
    std::array<double, 3> colour{};
    for (std::size_t channel = 0; channel < colour.size(); ++channel) {
        double value = 0;
        for (std::size_t power = coefficients.size(); power-- > 0;)
            value = value * x + coefficients[power][channel];
        colour[channel] = std::clamp(value, 0.0, 1.0);
    }
    return colour;
}

}  // namespace reliefbench
