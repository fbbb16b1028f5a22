#include "metrics/work.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

template <typename Value>
Image<Value> row(const std::vector<Value>& values) {
    Image<Value> image({static_cast<int>(values.size()), 1});
    image.texels = values;
    return image;
}

TEST(Work, IsAveragedOverCoveredPixelsOnly) {
    const auto work = summarize_work(row<std::uint8_t>({1, 1, 0}),
                                     row<PixelWork>({{4, 16, 3, 0}, {8, 32, 5, 1}, {100, 100, 100, 1}}), {}, nullptr);
    ASSERT_TRUE(work);
    EXPECT_EQ(work->covered_pixels, 2U);
    EXPECT_EQ(work->taps_mean(), 6);
    EXPECT_EQ(work->texels_mean(), 24);
    EXPECT_EQ(work->steps.mean, 4);
    EXPECT_EQ(work->unconverged, 0.5);
    EXPECT_FALSE(work->shadow_taps);
}

TEST(Work, StageTapsAreSpreadOverCoveredPixels) {
    const auto work = summarize_work(row<std::uint8_t>({1, 1, 1, 1}), row<PixelWork>({{}, {}, {}, {}}),
                                     {.taps = 10, .texels = 40}, nullptr);
    ASSERT_TRUE(work);
    EXPECT_EQ(work->taps_mean(), 2.5);
    EXPECT_EQ(work->taps_p95(), 2.5);
    EXPECT_EQ(work->texels_mean(), 10);
}

TEST(Work, TapsOfShadowsStandByThemselves) {
    const Image<std::uint32_t> shadow_taps = row<std::uint32_t>({5, 7, 100});
    const auto work = summarize_work(row<std::uint8_t>({1, 1, 0}), row<PixelWork>({{4}, {4}, {4}}), {}, &shadow_taps);
    ASSERT_TRUE(work && work->shadow_taps);
    EXPECT_EQ(work->shadow_taps->mean, 6);
    EXPECT_EQ(work->taps_mean(), 4);
}

TEST(Work, IsUndefinedWhereNothingIsCovered) {
    EXPECT_FALSE(summarize_work(row<std::uint8_t>({0}), row<PixelWork>({{4, 16, 3, 0}}), {}, nullptr));
}

}  // namespace
}  // namespace reliefbench
