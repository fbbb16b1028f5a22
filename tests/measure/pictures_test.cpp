#include "measure/pictures.hpp"

#include "metrics/coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {
namespace {

/// Three pixels: both hit, the technique searches and misses, nothing is drawn.
struct ThreePixels {
    Probe probe;
    Truth truth;
    HeightMap map = make_height_map(Image<float>({100, 100}, 0.5F), HeightFormat::r16, "flat");
    Relief relief;

    ThreePixels() {
        constexpr Resolution size{3, 1};
        const Hit hit{0.5F, 0.5F, 0.5F, 1.0F};
        probe.hits = HitImage(size);
        probe.hits.at(0, 0) = {0.52F, 0.5F, 0.5F, 1.25F};
        probe.colour = Image<std::array<float, 3>>(size, {0.2F, 0.3F, 0.4F});
        probe.covered = Image<std::uint8_t>(size, 1);
        probe.covered.at(2, 0) = 0;
        probe.work = Image<PixelWork>(size);
        probe.work.at(0, 0).taps = 5;
        probe.work.at(1, 0).taps = 9;
        probe.stages.taps = 4;
        truth.hits = HitImage(size, hit);
        truth.hits.at(2, 0) = Hit{};
        truth.colour = Image<std::array<float, 3>>(size, {0.2F, 0.3F, 0.4F});
        truth.footprint = Image<std::uint8_t>(size, 1);
    }

    DrawnCell cell() const { return {probe, truth, map, relief}; }
};

TEST(PixelMaps, TapsOfOtherStagesAreSpreadOverCoveredPixels) {
    const ThreePixels pixels;
    const Image<float> taps = pixel_map(PixelMap::taps, pixels.cell());
    EXPECT_EQ(taps.at(0, 0), 5 + 4 / 2.0F);
    EXPECT_EQ(taps.at(1, 0), 9 + 4 / 2.0F) << "a search in vain costs as well";
    EXPECT_TRUE(std::isnan(taps.at(2, 0)));
}

TEST(PixelMaps, AreUndefinedWhereNotBothHit) {
    const ThreePixels pixels;
    EXPECT_NEAR(pixel_map(PixelMap::uv_error, pixels.cell()).at(0, 0), 2, 1e-4);
    EXPECT_EQ(pixel_map(PixelMap::depth_error, pixels.cell()).at(0, 0), 0.25F);
    EXPECT_EQ(pixel_map(PixelMap::normal_error, pixels.cell()).at(0, 0), 0);
    for (const PixelMap map : {PixelMap::uv_error, PixelMap::depth_error, PixelMap::normal_error}) {
        EXPECT_TRUE(std::isnan(pixel_map(map, pixels.cell()).at(1, 0)));
        EXPECT_TRUE(std::isnan(pixel_map(map, pixels.cell()).at(2, 0)));
    }
    EXPECT_EQ(pixel_map(PixelMap::flip, pixels.cell()).texels, std::vector<float>(3, 0));
    EXPECT_EQ(pixel_map(PixelMap::coverage, pixels.cell()).texels,
              (std::vector<float>{static_cast<float>(Coverage::both), static_cast<float>(Coverage::missed),
                                  static_cast<float>(Coverage::neither)}));
}

TEST(PixelMaps, LayersHoldThemAllByName) {
    const ThreePixels pixels;
    const RasterFile raster = layers(pixels.cell());
    ASSERT_EQ(raster.values.size(), 3 * raster.channel_names.size());
    for (const PixelMapScale& scale : pixel_map_scales()) {
        const auto name = std::find(raster.channel_names.begin(), raster.channel_names.end(), scale.name);
        ASSERT_NE(name, raster.channel_names.end()) << scale.name;
        const auto channel = static_cast<std::size_t>(name - raster.channel_names.begin());
        EXPECT_EQ(raster.values[channel], pixel_map(scale.map, pixels.cell()).at(0, 0)) << scale.name;
    }
}

}  // namespace
}  // namespace reliefbench
