#include "scene/colour.hpp"

#include <gtest/gtest.h>

#include <array>

namespace reliefbench {
namespace {

TEST(Colour, EncodesSrgbAsTheStandardSays) {
    EXPECT_DOUBLE_EQ(srgb_encode(0), 0);
    EXPECT_NEAR(srgb_encode(1), 1, 1e-12);
    // IEC 61966-2-1: the linear part ends at 0.0031308; 18 % grey is 0.4613561.
    EXPECT_NEAR(srgb_encode(0.001), 0.01292, 1e-12);
    EXPECT_NEAR(srgb_encode(0.18), 0.4613561, 1e-7);
    EXPECT_NEAR(srgb_decode(0.5), 0.2140411, 1e-7);
}

TEST(Colour, DecodingUndoesEncoding) {
    for (int k = 0; k <= 1000; ++k) {
        // The standard's rounded constants leave a gap of this size where the two parts meet.
        EXPECT_NEAR(srgb_decode(srgb_encode(k / 1000.0)), k / 1000.0, 1e-8);
    }
}

TEST(Colour, ClampsToTheUnitRange) {
    EXPECT_EQ(srgb_encode(-1), 0);
    EXPECT_EQ(srgb_encode(2), srgb_encode(1));
    EXPECT_EQ(srgb_decode(-1), 0);
    EXPECT_EQ(srgb_decode(2), 1);
}

}  // namespace
}  // namespace reliefbench
