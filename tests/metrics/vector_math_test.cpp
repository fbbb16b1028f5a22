#include "metrics/vector_math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {
namespace {

constexpr double float_epsilon = std::numeric_limits<float>::epsilon();

TEST(VectorMath, CubeRootsAreThoseOfTheLibrary) {
    for (float t = 1e-6F; t < 2e3F; t *= 1.01F) {
        const double expected = std::cbrt(static_cast<double>(t));
        EXPECT_NEAR(cube_root(t), expected, 2 * float_epsilon * expected) << t;
    }
}

TEST(VectorMath, LogarithmsAreThoseOfTheLibrary) {
    for (float x = 1e-30F; x < 1e30F; x *= 1.07F) {
        const double expected = std::log2(static_cast<double>(x));
        // Around 1 what counts is the absolute error.
        EXPECT_NEAR(log_2(x), expected, 2 * float_epsilon * std::max(1.0, std::abs(expected))) << x;
    }
    EXPECT_EQ(log_2(1.0F), 0.0F);
}

TEST(VectorMath, PowersAreThoseOfTheLibrary) {
    for (float x = 1e-6F; x < 400.0F; x *= 1.05F) {
        for (float y = 0; y <= 1.0F; y += 0.05F) {
            const double expected = std::pow(static_cast<double>(x), static_cast<double>(y));
            // The logarithm's rounding, up to 20 · ε / 2, is multiplied by ln 2 and y ≤ 1.
            EXPECT_NEAR(power(x, y), expected, 12 * float_epsilon * expected) << x << "^" << y;
        }
    }
}

TEST(VectorMath, PowersOfZeroAreZeroButForThePowerZero) {
    EXPECT_EQ(power(0.0F, 0.7F), 0.0F);
    EXPECT_EQ(power(0.0F, 1e-3F), 0.0F);
    EXPECT_EQ(power(0.0F, 0.0F), 1.0F);
    EXPECT_EQ(power(1.0F, 0.3F), 1.0F);
}

}  // namespace
}  // namespace reliefbench
