#include "metrics/error_maps.hpp"
#include "metrics/hit_errors.hpp"
#include "metrics/shadow_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

namespace reliefbench {
namespace {

/// Three triangles: two of a chart that meets itself again after u = 1, and one of a chart that does not.
BaseSurface two_charts() {
    auto mesh = std::make_shared<BaseMesh>();
    for (int vertex = 0; vertex < 9; ++vertex)
        mesh->vertices.push_back({glm::vec3(vertex, vertex % 2, 0), glm::vec3(0, 0, 1), glm::vec2(0)});
    mesh->triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    mesh->charts = {0, 0, 1};
    mesh->chart_periods = {glm::vec2(1, 0), glm::vec2(0)};
    return {MeshBase{std::move(mesh)}};
}

/// One row of pixels over a map of 8 × 4 texels.
struct CurvedRow {
    explicit CurvedRow(std::size_t pixels)
        : size{static_cast<int>(pixels), 1},
          technique(size, {0.5F, 0.5F, 0.5F, 1}),
          truth(technique),
          footprint(size, in_footprint),
          technique_normals(size, {0, 0, 1}),
          truth_normals(size, {0, 0, 1}),
          entries(size, 0),
          off_chart(size, 0) {
        relief.base = two_charts();
    }

    ComparedHits compared() const {
        return {technique, truth,  footprint,
                map,       relief, CurvedHits{technique_normals, truth_normals, entries, off_chart}};
    }

    Resolution size;
    HitImage technique;
    HitImage truth;
    FootprintImage footprint;
    Image<std::array<float, 3>> technique_normals;
    Image<std::array<float, 3>> truth_normals;
    Image<std::uint32_t> entries;
    Image<std::uint8_t> off_chart;
    HeightMap map = make_height_map(Image<float>({8, 4}, 0.5F), HeightFormat::r32f, "flat");
    Relief relief;
};

TEST(CurvedErrors, CoordinatesGoTheShortestWayRoundAChartThatMeetsItself) {
    // Entered by the chart with a seam, the technique goes on past it in u, and the truth begins anew: 1/8 of a patch
    // apart, one texel. By the other chart the same coordinates are 7/8 apart, seven texels; and along v no chart
    // wraps.
    CurvedRow row(4);
    row.technique.texels = {{1.0625F, 0.5F, 0, 1}, {1.0625F, 0.5F, 0, 1}, {0.5F, 1.25F, 0, 1}, {-1.9375F, 0.5F, 0, 1}};
    row.truth.texels = {{0.1875F, 0.5F, 0, 1}, {0.1875F, 0.5F, 0, 1}, {0.5F, 0.25F, 0, 1}, {0.9375F, 0.5F, 0, 1}};
    row.entries.texels = {1, 2, 0, 1};
    const Image<float> errors = uv_error_map(row.compared());
    EXPECT_EQ(errors.texels, (std::vector<float>{1, 7, 4, 1}));
    const HitErrors all = compare_hits(row.compared());
    EXPECT_EQ(all.pixels.uv_texels, (std::vector<double>{1, 7, 4, 1}));
}

TEST(CurvedErrors, HitsOnAnotherChartHaveNoErrorOfCoordinates) {
    CurvedRow row(5);
    // On the chart and 2 texels off; on another chart, twice, once without an answer of the technique; outside F.
    row.technique.texels[0] = {0.75F, 0.5F, 0.5F, 1.25F};
    row.technique.texels[1] = {0, 0, 0.5F, 2};
    row.technique.texels[2] = Hit{};
    row.off_chart.texels = {0, 1, 1, 0, 1};
    row.footprint.texels = {1, 1, 1, tie_in_footprint, 0};
    const HitErrors errors = compare_hits(row.compared());
    EXPECT_EQ(errors.compared, 2U);
    EXPECT_EQ(errors.off_chart, 1.0 / 4);
    EXPECT_EQ(errors.missed, 1.0 / 4);
    EXPECT_EQ(errors.pixels.uv_texels, std::vector<double>{2});
    EXPECT_EQ(errors.uv_texels->max, 2);
    EXPECT_EQ(errors.pixels.depth, (std::vector<double>{0.25, 1})) << "how deep they are is as well known as elsewhere";
    const Image<float> map = uv_error_map(row.compared());
    EXPECT_EQ(map.texels[0], 2);
    EXPECT_TRUE(std::isnan(map.texels[1]));
}

TEST(CurvedErrors, WithEveryHitOnAnotherChartHaveNoCoordinates) {
    CurvedRow row(1);
    row.off_chart.texels = {1};
    const HitErrors errors = compare_hits(row.compared());
    EXPECT_EQ(errors.off_chart, 1);
    EXPECT_FALSE(errors.uv_texels);
    EXPECT_TRUE(errors.depth);
}

TEST(CurvedErrors, NormalsAreThoseThatWereShaded) {
    CurvedRow row(2);
    const auto lean = static_cast<float>(std::sqrt(0.5));
    row.technique_normals.texels = {{0, lean, lean}, {0, 0, 1}};
    row.truth_normals.texels = {{0, 0, 1}, {1, 0, 0}};
    const HitErrors errors = compare_hits(row.compared());
    EXPECT_NEAR(errors.pixels.normal_deg[0], 45, 1e-5);
    EXPECT_NEAR(errors.pixels.normal_deg[1], 90, 1e-12);
    EXPECT_NEAR(normal_error_map(row.compared()).texels[1], 90, 1e-5);
}

TEST(CurvedErrors, ShadowsAreSeenWhereTheTruthsNormalFacesTheLight) {
    CurvedRow row(2);
    row.truth_normals.texels = {{0, 1, 0}, {0, -1, 0}};
    Lighting lighting;
    lighting.lights = {{{0, 1, 0}}};
    const VisibilityImage lit(row.size, {1, 1, 1});
    const ShadowErrors errors = compare_shadows(VisibilityImage(row.size, {0, 0, 0}), lit, row.compared(), lighting);
    EXPECT_EQ(errors.compared, 1U);
    EXPECT_EQ(errors.mean, 1);
}

TEST(CurvedErrors, OnAFlatBaseThereAreNoOtherCharts) {
    const CurvedRow row(1);
    const Relief flat;
    EXPECT_FALSE(compare_hits({row.technique, row.truth, row.footprint, row.map, flat}).off_chart);
}

}  // namespace
}  // namespace reliefbench
