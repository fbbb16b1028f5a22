#include "picture/map_picture.hpp"

#include "picture/colour_map.hpp"
#include "picture/style.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace reliefbench {
namespace {

constexpr float undefined = std::numeric_limits<float>::quiet_NaN();

int brightness(const Rgb8& colour) {
    return colour[0] + colour[1] + colour[2];
}

TEST(MapPicture, TellsErrorsMissesAndFalseHitsApart) {
    Image<float> errors({7, 1});
    errors.texels = {0, 0.1F, 20, undefined, undefined, undefined, undefined};
    Image<Coverage> coverage({7, 1});
    coverage.texels = {Coverage::both,      Coverage::both,    Coverage::both,          Coverage::missed,
                       Coverage::false_hit, Coverage::neither, Coverage::missed_outside};
    const Picture picture = map_picture(scale_of(PixelMap::uv_error), errors, coverage);
    EXPECT_LT(brightness(picture.at(0, 0)), brightness(picture.at(1, 0)));
    EXPECT_LT(brightness(picture.at(1, 0)), brightness(picture.at(2, 0)));
    const Rgb8 missed = picture.at(3, 0);
    const Rgb8 false_hit = picture.at(4, 0);
    const Rgb8 nothing = picture.at(5, 0);
    const Rgb8 outside = picture.at(6, 0);
    EXPECT_GT(missed[2], 2 * std::max(missed[0], missed[1])) << "missed is blue";
    EXPECT_GT(false_hit[1], std::max(false_hit[0], false_hit[2])) << "a false hit is green";
    EXPECT_TRUE(nothing[0] == nothing[1] && nothing[1] == nothing[2]) << "nothing is grey";
    EXPECT_GT(std::min(outside[1], outside[2]), 2 * outside[0]) << "missed outside the footprint is cyan";
}

TEST(MapPicture, HitsOnAnotherChartAreNoErrorAsInATie) {
    Image<float> errors({2, 1});
    errors.texels = {undefined, undefined};
    Image<Coverage> coverage({2, 1});
    coverage.texels = {Coverage::both, Coverage::tie};
    const Picture picture = map_picture(scale_of(PixelMap::uv_error), errors, coverage);
    EXPECT_EQ(picture.at(0, 0), picture.at(1, 0));
}

TEST(MapPicture, WhatHasNoTapsIsNothingWhateverTheTruth) {
    Image<float> taps({2, 1});
    taps.texels = {undefined, 30};
    Image<Coverage> coverage({2, 1}, Coverage::missed);
    const Picture picture = map_picture(scale_of(PixelMap::taps), taps, coverage);
    const Rgb8 nothing = picture.at(0, 0);
    EXPECT_TRUE(nothing[0] == nothing[1] && nothing[1] == nothing[2]);
    EXPECT_NE(picture.at(1, 0), nothing) << "a pixel that searched in vain has its taps";
}

TEST(MapPicture, CoverageIsShownByItselfToo) {
    Image<Coverage> coverage({5, 1});
    coverage.texels = {Coverage::neither, Coverage::both, Coverage::missed, Coverage::false_hit,
                       Coverage::missed_outside};
    const Picture picture = map_picture(scale_of(PixelMap::coverage), Image<float>({5, 1}), coverage);
    EXPECT_EQ(std::set<Rgb8>(picture.texels.begin(), picture.texels.end()).size(), 5U);
}

TEST(Legend, ShowsTheWholeColourMapFromDarkToLight) {
    const Font font;
    for (const PixelMapScale& scale : pixel_map_scales()) {
        if (scale.marks.empty()) continue;
        const Picture picture = legend(scale, 200, font);
        ASSERT_EQ(picture.size.width, 200);
        int rows = 0;
        for (int y = 0; y < picture.size.height; ++y) {
            if (picture.at(0, y) != to_rgb8(magma(0))) continue;
            EXPECT_EQ(picture.at(199, y), to_rgb8(magma(1))) << scale.name;
            ++rows;
        }
        EXPECT_GE(rows, 5) << scale.name;
    }
}

TEST(Legend, NamesEveryColourThatStandsForNoValue) {
    for (const PixelMapScale& scale : pixel_map_scales()) {
        Image<Coverage> coverage({5, 1});
        coverage.texels = {Coverage::neither, Coverage::missed, Coverage::false_hit, Coverage::missed_outside,
                           Coverage::tie};
        std::set<Rgb8> named;
        for (const Swatch& swatch : swatches_of(scale)) {
            EXPECT_TRUE(named.insert(swatch.colour).second) << scale.name << ": " << swatch.text;
        }
        const Picture picture = map_picture(scale, Image<float>({5, 1}, undefined), coverage);
        for (const Rgb8& colour : picture.texels) {
            EXPECT_TRUE(named.contains(colour)) << scale.name;
        }
    }
}

TEST(Legend, IsNeverTooNarrowToRead) {
    const Font font;
    EXPECT_GE(legend(scale_of(PixelMap::depth_error), 8, font).size.width,
              font.width("Depth error, patch widths", style::small_text));
}

}  // namespace
}  // namespace reliefbench
