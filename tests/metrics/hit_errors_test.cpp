#include "metrics/hit_errors.hpp"

#include "metrics/error_maps.hpp"
#include "scene/shading_normal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace reliefbench;

namespace {

const Hit miss{};

/// One row of pixels.
HitImage row(const std::vector<Hit>& hits) {
    HitImage image(Resolution{static_cast<int>(hits.size()), 1});
    image.texels = hits;
    return image;
}

Image<std::uint8_t> row_footprint(const std::vector<std::uint8_t>& inside) {
    Image<std::uint8_t> image(Resolution{static_cast<int>(inside.size()), 1});
    image.texels = inside;
    return image;
}

HeightMap flat_map(Resolution size) {
    return make_height_map(Image<float>(size, 0.5F), HeightFormat::r32f, "flat");
}

const std::vector<std::uint8_t> all_inside{1, 1, 1, 1};

TEST(HitErrors, UvErrorIsInTexelsOfEachDirection) {
    // 8 × 4 texels tiled twice: 16 texels across the patch, 8 along it. (3/16, 4/8) off is 3 and 4 texels: 5.
    Relief relief;
    relief.tiling = 2;
    const HitErrors errors = compare_hits(
        {row({{0.1875F, 0.5F, 0.5F, 1}}), row({{0, 0, 0.5F, 1}}), row_footprint({1}), flat_map({8, 4}), relief});
    ASSERT_TRUE(errors.uv_texels);
    EXPECT_EQ(errors.uv_texels->max, 5.0);
    EXPECT_EQ(errors.uv_texels->mean, 5.0);
    EXPECT_EQ(errors.uv_texels->rms, 5.0);
    EXPECT_EQ(uv_error_map({row({{0.1875F, 0.5F, 0.5F, 1}}), row({{0, 0, 0.5F, 1}}), row_footprint({1}),
                            flat_map({8, 4}), relief})
                  .at(0, 0),
              5.0F);
}

TEST(HitErrors, CoordinatesAreNeverWrapped) {
    // A whole patch apart: the same texel of the map, but 8 texels of error.
    const HitErrors errors = compare_hits(
        {row({{1.25F, 0, 0, 1}}), row({{0.25F, 0, 0, 1}}), row_footprint({1}), flat_map({8, 4}), Relief{}});
    EXPECT_EQ(errors.uv_texels->max, 8.0);
}

TEST(HitErrors, OnlyTheMeanOfTheDepthErrorIsSigned) {
    const HitErrors errors = compare_hits({row({{0, 0, 0, 1.5F}, {0, 0, 0, 0.5F}, {0, 0, 0, 0}, {0, 0, 0, 1}}),
                                           row({{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}}),
                                           row_footprint(all_inside), flat_map({4, 4}), Relief{}});
    // +0.5, −0.5, −1, 0
    ASSERT_TRUE(errors.depth);
    EXPECT_EQ(errors.depth->mean, -0.25);
    EXPECT_EQ(errors.depth->p50, 0.5);
    EXPECT_EQ(errors.depth->max, 1.0);
    EXPECT_EQ(errors.depth->rms, std::sqrt(1.5 / 4));
}

TEST(HitErrors, MissedAndFalseHitsAreFractionsOfTheFootprint) {
    const Hit hit{0.5F, 0.5F, 0.5F, 1};
    // Inside: compared, missed, missed, false, neither; outside: a technique's hit that no truth has.
    const HitErrors errors =
        compare_hits({row({hit, miss, miss, hit, miss, hit}), row({hit, hit, hit, miss, miss, miss}),
                      row_footprint({1, 1, 1, 1, 1, 0}), flat_map({4, 4}), Relief{}});
    EXPECT_EQ(errors.footprint, 5U);
    EXPECT_EQ(errors.compared, 1U);
    EXPECT_EQ(errors.missed, 2.0 / 5);
    EXPECT_EQ(errors.false_hits, 1.0 / 5);
    EXPECT_EQ(errors.outside_quad_pixels, 0U);
    EXPECT_FALSE(errors.outside_quad_covered);
    EXPECT_EQ(errors.coverage_iou, 1.0 / 5);  // one in common of five covered
}

TEST(HitErrors, TiesAreCountedAndLeftOut) {
    const Hit hit{0.5F, 0.5F, 0.5F, 1};
    const Hit far{0.75F, 0.5F, 0.5F, 1};
    const HitErrors errors = compare_hits({row({hit, far, miss, hit}), row({hit, hit, hit, miss}),
                                           row_footprint({1, tie_in_footprint, tie_in_footprint, tie_in_footprint}),
                                           flat_map({4, 4}), Relief{}});
    EXPECT_EQ(errors.footprint, 4U);
    EXPECT_EQ(errors.ties, 3.0 / 4);
    EXPECT_EQ(errors.compared, 1U);
    EXPECT_EQ(errors.uv_texels->max, 0);
    EXPECT_EQ(errors.missed + errors.false_hits, 0);
    EXPECT_EQ(errors.coverage_iou, 1);
}

TEST(HitErrors, TruthOutsideTheFootprintIsCountedApart) {
    const Hit hit{0.5F, 0.5F, 0.5F, 1};
    const Hit far{0.9F, 0.5F, 0.5F, 2};
    const HitErrors errors = compare_hits({row({hit, far, miss, miss}), row({hit, hit, hit, hit}),
                                           row_footprint({1, 0, 0, 0}), flat_map({4, 4}), Relief{}});
    EXPECT_EQ(errors.outside_quad_pixels, 3U);
    EXPECT_EQ(errors.outside_quad_covered, 1.0 / 3);
    EXPECT_EQ(errors.missed, 0);
    EXPECT_EQ(errors.compared, 1U);
    EXPECT_EQ(errors.uv_texels->max, 0) << "hits outside F must not enter the error";
    EXPECT_EQ(errors.coverage_iou, 0.5);
}

TEST(HitErrors, ARepeatingReliefIsComparedInsideTheFootprintOnly) {
    Relief relief;
    relief.boundary = Boundary::repeat;
    const Hit hit{0.5F, 0.5F, 0.5F, 1};
    const HitErrors errors =
        compare_hits({row({hit, hit}), row({hit, miss}), row_footprint({1, 0}), flat_map({4, 4}), relief});
    EXPECT_EQ(errors.coverage_iou, 1);
    EXPECT_EQ(errors.false_hits, 0);
}

TEST(HitErrors, NothingInCommonLeavesTheErrorsEmpty) {
    const Hit hit{0.5F, 0.5F, 0.5F, 1};
    const HitErrors errors = compare_hits({row({miss}), row({hit}), row_footprint({1}), flat_map({4, 4}), Relief{}});
    EXPECT_FALSE(errors.uv_texels);
    EXPECT_FALSE(errors.depth);
    EXPECT_FALSE(errors.normal_deg);
    EXPECT_EQ(errors.compared, 0U);
    EXPECT_EQ(errors.missed, 1);
    EXPECT_EQ(errors.coverage_iou, 0);
}

TEST(HitErrors, AnEmptyImageIsNoDivisionByZero) {
    const HitErrors errors = compare_hits({row({miss}), row({miss}), row_footprint({0}), flat_map({4, 4}), Relief{}});
    EXPECT_EQ(errors.missed, 0);
    EXPECT_EQ(errors.false_hits, 0);
    EXPECT_EQ(errors.coverage_iou, 1);
}

TEST(HitErrors, HitsThatAreNotFiniteAreMisses) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const Hit hit{0.5F, 0.5F, 0.5F, 1};
    const HitErrors errors =
        compare_hits({row({{nan, 0, 0, 1}, {0, infinite, 0, 1}, {0, 0, 0, infinite}, {0, 0, 0, nan}}),
                      row({hit, hit, hit, hit}), row_footprint(all_inside), flat_map({4, 4}), Relief{}});
    EXPECT_EQ(errors.missed, 1);
    EXPECT_EQ(errors.compared, 0U);
}

TEST(HitErrors, PercentilesSeeEveryPixel) {
    // Errors of 0, 1, ..., 199 texels, one pixel each: p99 = 0.99 · 199 between the last but two and the last but one.
    std::vector<Hit> hits;
    for (int texels = 0; texels < 200; ++texels) {
        hits.push_back({static_cast<float>(texels) / 4, 0, 0, 1});
    }
    const HitErrors errors =
        compare_hits({row(hits), row(std::vector<Hit>(200, Hit{0, 0, 0, 1})),
                      row_footprint(std::vector<std::uint8_t>(200, 1)), flat_map({4, 4}), Relief{}});
    EXPECT_DOUBLE_EQ(errors.uv_texels->p50, 99.5);
    EXPECT_DOUBLE_EQ(errors.uv_texels->p95, 189.05);
    EXPECT_DOUBLE_EQ(errors.uv_texels->p99, 197.01);
}

TEST(HitErrors, OneInAThousandPixelsIsAFigure) {
    // Errors of 0 texels but for two pixels in a thousand, of 4 and 8: p99.9 = 0.999 · 999 between these.
    std::vector<Hit> hits(1000, Hit{0, 0, 0, 1});
    hits[500] = {1, 0, 0, 1};
    hits[7] = {2, 0, 0, 1};
    const HitErrors errors =
        compare_hits({row(hits), row(std::vector<Hit>(1000, Hit{0, 0, 0, 1})),
                      row_footprint(std::vector<std::uint8_t>(1000, 1)), flat_map({4, 4}), Relief{}});
    EXPECT_EQ(errors.uv_texels->p99, 0);
    const auto p999 = [](const HitErrors& of) {
        for (const auto& [path, value] : figures_of(of)) {
            if (path == "error.uv_texels.p999") return value;
        }
        return std::optional<double>(-1);
    };
    EXPECT_NEAR(p999(errors).value(), 4 + 4 * 0.001, 1e-9);
    EXPECT_FALSE(p999(HitErrors{})) << "no pixel is compared";
}

/// Heights that rise along u by 1/4 per texel, back at 0 past the border; 4 × 1 texels.
HeightMap ramp() {
    Image<float> heights(Resolution{4, 1});
    heights.texels = {0, 0.25F, 0.5F, 0.75F};
    return make_height_map(heights, HeightFormat::r32f, "ramp");
}

TEST(HitErrors, NormalErrorIsTheAngleBetweenTheShadingNormals) {
    // ∂h/∂u at the texel centres: (h[i+1] − h[i−1])·4/2 = −1, 1, 1, −1. With H = 1 the normals lean by 45° one way
    // and the other: 90° apart.
    Relief relief;
    relief.height_scale = 1;
    const Hit rising{0.375F, 0.5F, 0.25F, 1};
    const Hit falling{0.125F, 0.5F, 0, 1};
    const HitErrors errors =
        compare_hits({row({falling, rising}), row({rising, rising}), row_footprint({1, 1}), ramp(), relief});
    EXPECT_NEAR(errors.normal_deg->max, 90, 1e-12);
    EXPECT_NEAR(errors.normal_deg->mean, 45, 1e-12);
}

TEST(ShadingNormal, InterpolatesSlopesAndRepeats) {
    Relief relief;
    relief.height_scale = 0.5;
    relief.tiling = 2;
    const Image<std::array<float, 2>> derivatives = height_derivatives(ramp());
    // H·tiling = 1. Texture coordinate 0.375 (texel 1, slope 1), reached at u = 0.1875 and one repeat later.
    const double root_half = std::numbers::sqrt2 / 2;
    for (const double u : {0.1875, 0.6875, -0.3125}) {
        const glm::dvec3 normal = shading_normal(derivatives, relief, u, 0.3);
        EXPECT_NEAR(normal.x, -root_half, 1e-15);
        EXPECT_EQ(normal.y, 0);
        EXPECT_NEAR(normal.z, root_half, 1e-15);
    }
    // Halfway between texels 0 (slope −1) and 1 (slope 1), and halfway over the border between 3 and 0 (both −1).
    EXPECT_NEAR(shading_normal(derivatives, relief, 0.125, 0).x, 0, 1e-15);
    EXPECT_NEAR(shading_normal(derivatives, relief, 0, 0).x, root_half, 1e-15);
}

}  // namespace
