#include "measure/cell_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace reliefbench {
namespace {

/// Two pixels in which both hit the same, over a base of one triangle or a plane; a fragment ran in one of them.
struct TwoPixels {
    explicit TwoPixels(bool is_curved) {
        constexpr Resolution size{2, 1};
        probe.hits = HitImage(size, {0.5F, 0.5F, 0.5F, 1.0F});
        probe.colour = Image<std::array<float, 3>>(size);
        probe.covered = Image<std::uint8_t>(size, 1);
        probe.covered.at(1, 0) = 0;
        truth.hits = probe.hits;
        truth.colour = probe.colour;
        truth.footprint = FootprintImage(size, in_footprint);
        if (!is_curved) return;
        const auto mesh = std::make_shared<BaseMesh>();
        mesh->charts = {0};
        mesh->chart_periods = {glm::vec2(0)};
        relief.base = {MeshBase{mesh}};
        probe.normals = Image<std::array<float, 3>>(size, {0, 0, 1});
        truth.curved = CurvedTruth{.normals = Image<std::array<float, 3>>(size, {0, 1, 0}),
                                   .entry_triangles = Image<std::uint32_t>(size, 0),
                                   .off_chart = Image<std::uint8_t>(size, 0)};
        truth.curved->off_chart.at(1, 0) = 1;
    }

    std::optional<double> figure(const std::string& path, bool draws_base) const {
        const FigureValueList values = errors_of({probe, truth, map, relief, draws_base}, Lighting{}, false);
        const auto found = std::ranges::find(values, path, &FigureValueList::value_type::first);
        return found == values.end() ? std::nullopt : found->second;
    }

    Probe probe;
    Truth truth;
    HeightMap map = make_height_map(Image<float>({4, 4}, 0.5F), HeightFormat::r16, "flat");
    Relief relief;
};

TEST(CellFigures, RasteriserAndRayAreComparedWhereFragmentsAreTheBases) {
    EXPECT_EQ(TwoPixels(false).figure("error.raster_mismatch", true), 0.5);
    EXPECT_FALSE(TwoPixels(false).figure("error.raster_mismatch", false));
}

TEST(CellFigures, OverACurvedBaseNormalsAndChartsAreTheTruthsOwn) {
    const TwoPixels curved(true);
    EXPECT_EQ(curved.figure("error.off_chart", true), 0.5);
    EXPECT_NEAR(curved.figure("error.normal_deg.max", true).value(), 90, 1e-9);
    const TwoPixels flat(false);
    EXPECT_FALSE(flat.figure("error.off_chart", true));
    EXPECT_EQ(flat.figure("error.normal_deg.max", true), 0);
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
