#include "picture/pixel_map.hpp"

#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace reliefbench {
namespace {

TEST(PixelMap, ScalesRunFromDarkToLight) {
    const PixelMapScale& uv = scale_of(PixelMap::uv_error);
    EXPECT_EQ(uv.position(0), 0);
    EXPECT_EQ(uv.position(0.01), 0);
    EXPECT_NEAR(uv.position(0.1), 1.0 / 3, 1e-12);
    EXPECT_EQ(uv.position(10), 1);
    EXPECT_EQ(uv.position(1e6), 1);
    const PixelMapScale& flip = scale_of(PixelMap::flip);
    EXPECT_EQ(flip.position(0.25), 0.25);
}

TEST(PixelMap, EqualSurroundingsAreDarkInSsim) {
    const PixelMapScale& ssim = scale_of(PixelMap::ssim);
    EXPECT_EQ(ssim.position(1), 0);
    EXPECT_EQ(ssim.position(0.25), 0.75);
    EXPECT_EQ(ssim.position(-0.5), 1);
}

TEST(PixelMap, ALogarithmicScaleShowsMagnitudes) {
    const PixelMapScale& depth = scale_of(PixelMap::depth_error);
    EXPECT_EQ(depth.position(-1e-3), depth.position(1e-3));
    EXPECT_NEAR(depth.position(1e-3), 0.5, 1e-12);
}

TEST(PixelMap, EachHasANameOfItsOwnByWhichItIsFound) {
    std::set<std::string> names;
    for (const PixelMapScale& scale : pixel_map_scales()) {
        EXPECT_TRUE(names.insert(scale.name).second) << scale.name;
        EXPECT_EQ(parse_pixel_map(scale.name), scale.map);
        EXPECT_EQ(&scale_of(scale.map), &scale);
        for (const double mark : scale.marks) {
            EXPECT_GE(mark, std::min(scale.dark, scale.light)) << scale.name;
            EXPECT_LE(mark, std::max(scale.dark, scale.light)) << scale.name;
        }
    }
    EXPECT_THAT(error_message([] { parse_pixel_map("flp"); }), testing::HasSubstr("did you mean 'flip'?"));
}

}  // namespace
}  // namespace reliefbench
