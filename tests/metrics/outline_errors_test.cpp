#include "metrics/outline_errors.hpp"

#include "core/random.hpp"
#include "metrics/distance_transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace reliefbench {
namespace {

using PixelSet = Image<std::uint8_t>;
using Inside = std::function<bool(double x, double y)>;

constexpr Resolution frame{160, 120};
const Hit somewhere{0.5F, 0.5F, 0.5F, 1};

PixelSet set_of(const Inside& is_inside) {
    PixelSet set(frame);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x)
            set.at(x, y) = is_inside(x, y) ? 1 : 0;
    }
    return set;
}

HitImage hits_of(const Inside& is_hit) {
    const PixelSet set = set_of(is_hit);
    HitImage hits(frame);
    std::transform(set.texels.begin(), set.texels.end(), hits.texels.begin(),
                   [](std::uint8_t hit) { return hit != 0 ? somewhere : Hit{}; });
    return hits;
}

Inside disc(double radius, double centre_x = 80, double centre_y = 60) {
    return [=](double x, double y) { return std::hypot(x - centre_x, y - centre_y) <= radius; };
}
Inside left_of(double end) {
    return [=](double x, double) { return x < end; };
}
bool everywhere(double, double) {
    return true;
}
bool nowhere(double, double) {
    return false;
}

/// The sum of the distances over a vertical edge to one so far off, in whose set the frame's upper and lower edge are
/// nearer at the ends.
double up_to_the_frame(double distance) {
    double sum = 0;
    for (int y = 0; y < frame.height; ++y)
        sum += std::min(distance, std::hypot(1, std::min(y, frame.height - 1 - y)));
    return sum;
}

OutlineErrors compare(const Inside& technique, const Inside& truth, const PixelSet& footprint,
                      Boundary boundary = Boundary::clip) {
    const HeightMap map = make_height_map(Image<float>({2, 2}, 0.5F), HeightFormat::r32f, "flat");
    Relief relief;
    relief.boundary = boundary;
    return compare_outlines({hits_of(technique), hits_of(truth), footprint, map, relief});
}

/// The figures as they are written, by path.
std::optional<double> figure(const OutlineErrors& errors, const std::string& path) {
    const FigureValueList values = figures_of(errors);
    const auto found = std::ranges::find(values, path, &FigureValueList::value_type::first);
    EXPECT_NE(found, values.end()) << path;
    return found->second;
}

TEST(DistancesBetween, AreThoseOfABruteForce) {
    Random random(7);
    for (const double density : {0.5, 0.02, 0.0005}) {
        constexpr Resolution size{61, 37};
        PixelSet from(size), to(size);
        for (std::size_t pixel = 0; pixel < size.pixels(); ++pixel) {
            from.texels[pixel] = random.uniform() < 0.3 ? 1 : 0;
            to.texels[pixel] = random.uniform() < density ? 1 : 0;
        }
        to.at(60, 3) = 1;
        std::vector<double> expected;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (from.at(x, y) == 0) continue;
                int nearest = std::numeric_limits<int>::max();
                for (int j = 0; j < size.height; ++j) {
                    for (int i = 0; i < size.width; ++i) {
                        if (to.at(i, j) != 0) nearest = std::min(nearest, (x - i) * (x - i) + (y - j) * (y - j));
                    }
                }
                expected.push_back(std::sqrt(static_cast<double>(nearest)));
            }
        }
        EXPECT_EQ(distances_between(from, to), expected) << density;
    }
}

TEST(OutlineErrors, OfTwoDiscsIsTheDifferenceOfTheirRadii) {
    const OutlineErrors errors = compare(disc(40), disc(33), set_of(everywhere));
    // The nearest of several pixels about a circle is a little nearer than the circle.
    EXPECT_NEAR(*errors.footprint.mean, 7, 0.2);
    EXPECT_NEAR(*errors.footprint.p95, 7, 0.5);
    // Four-connected outlines of pixels inside a circle: between 4·√2·r and 2π·r of them.
    EXPECT_NEAR(static_cast<double>(errors.footprint.pixels), 4 * std::sqrt(2.0) * (40 + 33), 20);
    EXPECT_EQ(figure(errors, "error.outline.mean"), errors.footprint.mean);
    EXPECT_EQ(figure(errors, "error.outline.p95"), errors.footprint.p95);
}

TEST(OutlineErrors, IsTheSameBothWays) {
    const OutlineErrors there = compare(disc(40), disc(30, 90, 60), set_of(everywhere));
    const OutlineErrors back = compare(disc(30, 90, 60), disc(40), set_of(everywhere));
    // Summed in another order.
    EXPECT_NEAR(*there.footprint.mean, *back.footprint.mean, 1e-12);
    EXPECT_EQ(there.footprint.p95, back.footprint.p95);
}

TEST(OutlineErrors, OfAShiftedEdgeIsTheShift) {
    const OutlineErrors errors = compare(left_of(70), left_of(64), set_of(everywhere));
    // From the truth's edge to the technique's, 6 in each row. Back it is less in the first and last rows, where the
    // frame ends the technique beyond the truth's edge.
    EXPECT_NEAR(*errors.footprint.mean, (6 * 120 + up_to_the_frame(6)) / 240, 1e-12);
    EXPECT_EQ(errors.footprint.p95, 6);
    EXPECT_EQ(errors.footprint.pixels, 2 * 120U);
}

TEST(OutlineErrors, WhatEndsWithTheFrameIsComparedWithTheFramesEdge) {
    // As parallel rays show a base: the frame is its bounding box.
    const OutlineErrors errors = compare(
        everywhere, [](double, double y) { return y >= 3; }, set_of(everywhere));
    // In the corners its other edges are nearer.
    double sum = 0;
    for (int x = 0; x < frame.width; ++x)
        sum += std::min(3.0, std::hypot(1, std::min(x, frame.width - 1 - x)));
    EXPECT_NEAR(*errors.footprint.mean, sum / 160, 1e-12);
    EXPECT_EQ(errors.footprint.p95, 3);
    EXPECT_EQ(errors.footprint.pixels, 160U);
    ASSERT_TRUE(errors.whole);
    EXPECT_EQ(errors.whole->mean, errors.footprint.mean);
}

TEST(OutlineErrors, AHoleHasNothingToBeComparedWithWhereTheTruthHasNoOutline) {
    const OutlineErrors errors =
        compare([](double x, double y) { return x != 80 || y != 60; }, everywhere, set_of(disc(50)));
    EXPECT_FALSE(errors.footprint.mean);
    EXPECT_EQ(errors.footprint.pixels, 4U);
}

TEST(OutlineErrors, LeaveOutWhereBothEndBecauseTheFootprintDoes) {
    // F ends at x = 100, and so does what both hit, but for the rows of y < 30, where the technique ends 5 pixels
    // early.
    const PixelSet footprint = set_of(left_of(100));
    const OutlineErrors errors =
        compare([](double x, double y) { return x < (y < 30 ? 95 : 100); }, everywhere, footprint);
    // The technique's vertical edge, at 94 against F's last pixel at 99, and its horizontal one, in row 30 from 95 to
    // 99, against F's last pixel in row 29. The truth ends with F, and nothing is measured from there.
    EXPECT_EQ(errors.footprint.pixels, 30 + 5U);
    // But in the first rows F's upper border, where the truth ends and the technique has ended before, is nearer.
    double sum = 0;
    for (int y = 0; y < 30; ++y)
        sum += std::min(5.0, std::hypot(1, y));
    for (int columns = 0; columns < 5; ++columns)
        sum += std::hypot(columns, 1);
    EXPECT_NEAR(*errors.footprint.mean, sum / 35, 1e-12);
}

TEST(OutlineErrors, ATechniqueThatFillsTheFootprintIsMeasuredAgainstTheFootprintsBorder) {
    // No silhouettes: it hits in all of F, and the truth's outline lies 8 pixels inside.
    const OutlineErrors errors = compare(disc(50), disc(42), set_of(disc(50)));
    EXPECT_NEAR(*errors.footprint.mean, 8, 0.2);
    EXPECT_GT(errors.footprint.pixels, 200U);
}

TEST(OutlineErrors, WithNoOutlineInSightAreUndefined) {
    for (const Inside& all : {Inside(everywhere), Inside(nowhere)}) {
        const OutlineErrors errors = compare(all, all, set_of(disc(50)));
        EXPECT_FALSE(errors.footprint.mean);
        EXPECT_FALSE(errors.footprint.p95);
        EXPECT_EQ(errors.footprint.pixels, 0U);
        EXPECT_FALSE(figure(errors, "error.outline.mean"));
        EXPECT_EQ(figure(errors, "error.outline.pixels"), 0);
    }
}

TEST(OutlineErrors, WithAnOutlineOnOneSideOnlyAreUndefinedAndCountIt) {
    for (const bool of_technique : {false, true}) {
        const Inside hit = disc(30);
        const OutlineErrors errors =
            compare(of_technique ? hit : nowhere, of_technique ? nowhere : hit, set_of(everywhere));
        EXPECT_FALSE(errors.footprint.mean);
        EXPECT_GT(errors.footprint.pixels, 100U);
    }
}

TEST(OutlineErrors, TakeNoDistanceFromTies) {
    PixelSet footprint = set_of(everywhere);
    // In one row the technique hits far beyond the truth's edge, all of it ties.
    for (int x = 0; x < frame.width; ++x)
        footprint.at(x, 50) = tie_in_footprint;
    const OutlineErrors errors =
        compare([](double x, double y) { return x < (y == 50 ? 130 : 64); }, left_of(64), footprint);
    EXPECT_EQ(errors.footprint.mean, 0);
    EXPECT_EQ(errors.footprint.pixels, 2 * 119U);
}

TEST(OutlineErrors, OfTheWholeFrameKnowNoFootprint) {
    // The truth goes on by 12 pixels beyond F, where the technique ends.
    const OutlineErrors errors = compare(left_of(80), left_of(92), set_of(left_of(80)));
    EXPECT_EQ(errors.footprint.pixels, 0U);
    ASSERT_TRUE(errors.whole);
    EXPECT_NEAR(*errors.whole->mean, (12 * 120 + up_to_the_frame(12)) / 240, 1e-12);
    EXPECT_EQ(errors.whole->p95, 12);
    EXPECT_EQ(figure(errors, "error.outline_all.mean"), errors.whole->mean);
    EXPECT_EQ(figure(errors, "error.outline_all.pixels"), 2 * 120);
}

TEST(OutlineErrors, OfAReliefThatGoesOnForEverEndWithTheFootprint) {
    const OutlineErrors errors = compare(left_of(80), left_of(70), set_of(left_of(80)), Boundary::repeat);
    EXPECT_NEAR(*errors.footprint.mean, up_to_the_frame(10) / 120, 1e-12) << "short of the footprint's own border";
    EXPECT_EQ(errors.footprint.p95, 10);
    EXPECT_FALSE(errors.whole);
    EXPECT_FALSE(figure(errors, "error.outline_all.pixels"));
}

}  // namespace
}  // namespace reliefbench
