#include "measure/cell_figures.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

Probe probe_with_work(const std::vector<PixelWork>& work, const std::vector<std::uint8_t>& covered) {
    const Resolution size{static_cast<int>(work.size()), 1};
    Probe probe;
    probe.hits = HitImage(size);
    probe.colour = Image<std::array<float, 3>>(size);
    probe.covered = Image<std::uint8_t>(size);
    probe.covered.texels = covered;
    probe.work = Image<PixelWork>(size);
    probe.work.texels = work;
    return probe;
}

TEST(Work, IsAveragedOverCoveredPixelsOnly) {
    const Probe probe = probe_with_work({{4, 16, 3, 0}, {8, 32, 5, 1}, {100, 100, 100, 1}}, {1, 1, 0});
    const std::optional<CellResult::Work> work = summarize_work(probe);
    ASSERT_TRUE(work);
    EXPECT_EQ(work->covered_pixels, 2U);
    EXPECT_EQ(work->taps_mean, 6);
    EXPECT_EQ(work->texels_mean, 24);
    EXPECT_EQ(work->steps_mean, 4);
    EXPECT_EQ(work->unconverged, 0.5);
}

TEST(Work, StageTapsAreSpreadOverCoveredPixels) {
    Probe probe = probe_with_work({{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}, {1, 1, 1, 1});
    probe.stages.taps = 10;
    probe.stages.texels = 40;
    const std::optional<CellResult::Work> work = summarize_work(probe);
    ASSERT_TRUE(work);
    EXPECT_EQ(work->taps_mean, 2.5);
    EXPECT_EQ(work->taps_p95, 2.5);
    EXPECT_EQ(work->texels_mean, 10);
}

TEST(Work, IsUndefinedWhereNothingIsCovered) {
    EXPECT_FALSE(summarize_work(probe_with_work({{4, 16, 3, 0}}, {0})));
}

TEST(Timing, MedianAndIntervalAreOfTheRounds) {
    const PassTiming timing = summarize_timing({{1, 2}, {3, 9}, {5}}, 4);
    EXPECT_EQ(timing.n, 5U);
    EXPECT_EQ(timing.rounds, 3U);
    // Of 1.5, 6 and 5.
    EXPECT_EQ(timing.median_ms, 5);
    // Of all samples.
    EXPECT_EQ(timing.mad_ms, 2);
    EXPECT_EQ(timing.repeats, 4);
    // Too few rounds for 95 %: the interval is the whole range.
    EXPECT_EQ(timing.ci95_ms.low, 1.5);
    EXPECT_EQ(timing.ci95_ms.high, 6);
}

TEST(Timing, OutliersAreCountedAndKept) {
    const PassTiming timing = summarize_timing({{1, 1.5, 2}, {1.25, 1.75, 100}}, 1);
    EXPECT_EQ(timing.outliers, 1U);
    EXPECT_EQ(timing.n, 6U);
}

TEST(Timing, PreparationIsTheSumOfItsPassesMedians) {
    Preparation preparation;
    preparation.pass_ms = {{"base", {1, 2, 9}}, {"levels", {0.5, 0.25, 4}}};
    EXPECT_EQ(preparation_ms(preparation), 2.5);
    EXPECT_EQ(preparation_ms({}), 0);
}

}  // namespace
}  // namespace reliefbench
