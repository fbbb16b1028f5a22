#include "picture/colour_map.hpp"

#include "scene/colour.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace reliefbench {
namespace {

TEST(ColourMap, FollowsThePublishedMap) {
    const std::array<std::pair<double, std::array<double, 3>>, 5> published{{
        {0.0, {0.001462, 0.000466, 0.013866}},
        {64 / 255.0, {0.316654, 0.071690, 0.485380}},
        {128 / 255.0, {0.716387, 0.214982, 0.475290}},
        {192 / 255.0, {0.986700, 0.535582, 0.382210}},
        {1.0, {0.987053, 0.991438, 0.749504}},
    }};
    for (const auto& [x, expected] : published) {
        const auto colour = magma(x);
        // The bound that the header promises for the fit.
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(colour[channel], expected[channel], 0.03) << x;
    }
}

TEST(ColourMap, GrowsBrighterAllTheWay) {
    double previous = -1;
    for (int k = 0; k <= 256; ++k) {
        const auto [red, green, blue] = magma(k / 256.0);
        const double luminance = 0.2126 * srgb_decode(red) + 0.7152 * srgb_decode(green) + 0.0722 * srgb_decode(blue);
        EXPECT_GT(luminance, previous) << k;
        previous = luminance;
    }
    EXPECT_EQ(magma(-3), magma(0));
    EXPECT_EQ(magma(7), magma(1));
}

}  // namespace
}  // namespace reliefbench
