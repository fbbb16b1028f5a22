#include "measure/pictures.hpp"

#include <gtest/gtest.h>

#include <array>

namespace reliefbench {
namespace {

std::array<float, 3> pixel(const RasterFile& raster, int x, int y) {
    const std::size_t first = (static_cast<std::size_t>(y) * raster.size.width + x) * 3;
    return {raster.values[first], raster.values[first + 1], raster.values[first + 2]};
}

float brightness(const std::array<float, 3>& colour) {
    return colour[0] + colour[1] + colour[2];
}

RasterFile plain(Resolution size, float value) {
    RasterFile raster;
    raster.size = size;
    raster.channel_names = {"R", "G", "B"};
    raster.values.assign(size.pixels() * 3, value);
    return raster;
}

TEST(Pictures, SideBySideKeepsEveryPixelAndPartsThemByALine) {
    const RasterFile joined = side_by_side({plain({3, 2}, 0.25F), plain({2, 2}, 0.5F)});
    ASSERT_EQ(joined.size, (Resolution{7, 2}));
    const std::vector<float> expected{0.25F, 0.25F, 0.25F, 1.0F, 1.0F, 0.5F, 0.5F};
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 7; ++x) {
            EXPECT_EQ(pixel(joined, x, y)[0], expected[static_cast<std::size_t>(x)]) << x << ", " << y;
        }
    }
}

TEST(Pictures, AreEncodedToSrgb) {
    // 0.5 linear is 0.7354 in sRGB (IEC 61966-2-1).
    const RasterFile picture = display_picture(Image<std::array<float, 3>>({1, 1}, {0.5F, 0.0F, 1.0F}));
    EXPECT_NEAR(pixel(picture, 0, 0)[0], 0.7354F, 1e-4F);
    EXPECT_EQ(pixel(picture, 0, 0)[1], 0.0F);
    EXPECT_EQ(pixel(picture, 0, 0)[2], 1.0F);
}

TEST(Pictures, ErrorMapTellsErrorsMissesAndFalseHitsApart) {
    const HeightMap map = make_height_map(Image<float>({100, 100}, 0.5F), HeightFormat::r16, "flat");
    const Hit here{0.5F, 0.5F, 0.5F, 1.0F};
    Truth truth;
    truth.hits = HitImage({7, 1}, here);
    truth.footprint = Image<std::uint8_t>({7, 1}, 1);
    truth.footprint.at(6, 0) = 0;
    truth.hits.at(4, 0) = Hit{};
    truth.hits.at(5, 0) = Hit{};
    HitImage hits({7, 1}, here);
    hits.at(1, 0).u += 0.001F;  // a tenth of a texel
    hits.at(2, 0).u += 0.2F;    // twenty texels
    hits.at(3, 0) = Hit{};
    hits.at(5, 0) = Hit{};
    hits.at(6, 0) = Hit{};
    const RasterFile picture = error_picture(hits, truth, map, Relief{});
    EXPECT_LT(brightness(pixel(picture, 0, 0)), brightness(pixel(picture, 1, 0)));
    EXPECT_LT(brightness(pixel(picture, 1, 0)), brightness(pixel(picture, 2, 0)));
    const std::array<float, 3> missed = pixel(picture, 3, 0);
    const std::array<float, 3> false_hit = pixel(picture, 4, 0);
    const std::array<float, 3> nothing = pixel(picture, 5, 0);
    const std::array<float, 3> outside = pixel(picture, 6, 0);
    EXPECT_GT(missed[2], 2 * std::max(missed[0], missed[1])) << "missed is blue";
    EXPECT_GT(std::min(outside[1], outside[2]), 2 * outside[0]) << "missed outside the quad is cyan";
    EXPECT_GT(false_hit[1], std::max(false_hit[0], false_hit[2])) << "a false hit is green";
    EXPECT_TRUE(nothing[0] == nothing[1] && nothing[1] == nothing[2]) << "nothing is grey";
}

}  // namespace
}  // namespace reliefbench
