#include "advice/map_faults.hpp"

#include "core/random.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = MapFault::Kind;

constexpr int side = 128;

HeightMap map_of(const std::function<double(int x, int y)>& height, HeightFormat format = HeightFormat::r16) {
    Image<float> heights({side, side});
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x)
            heights.at(x, y) = static_cast<float>(height(x, y));
    }
    return make_height_map(heights, format, "tested.png");
}

double wave(double x, double y) {
    const double turn = 2 * std::numbers::pi / side;
    return 0.5 + 0.25 * std::sin(2 * turn * x) + 0.25 * std::cos(turn * y);
}

double in_steps(double height, double steps) {
    return std::round(height * steps) / steps;
}

std::vector<Kind> kinds(const std::vector<MapFault>& faults) {
    std::vector<Kind> all;
    for (const MapFault& fault : faults)
        all.push_back(fault.kind);
    return all;
}

TEST(MapFaults, ASmoothMapHasNone) {
    EXPECT_THAT(map_faults(map_of(wave), {.repeats = true}), IsEmpty());
}

TEST(MapFaults, TilesWithFlatTopsAndSteepEdgesHaveNone) {
    const auto tiles = [](int x, int y) {
        const int edge = std::min(std::min(x % 16, 15 - x % 16), std::min(y % 16, 15 - y % 16));
        return std::min(1.0, 0.15 + edge * 0.25 + 0.05 * wave(x, y));
    };
    EXPECT_THAT(map_faults(map_of(tiles), {}), IsEmpty());
}

TEST(MapFaults, AConstantMapIsToldAndNothingElse) {
    const std::vector<MapFault> faults = map_faults(map_of([](int, int) { return 0.5; }), {.repeats = true});
    ASSERT_THAT(kinds(faults), ElementsAre(Kind::constant));
    EXPECT_THAT(faults.front().text, HasSubstr("'tested.png' is constant"));
}

TEST(MapFaults, WhatShiftsNothingByHalfAPixelIsNearlyFlatAtThatAngleAndResolution) {
    const HeightMap shallow = map_of([](int x, int y) { return 0.5 + 0.01 * (wave(x, y) - 0.5); });
    const std::vector<MapFault> faults = map_faults(shallow, {.steepest_view_angle = 60, .pixels_per_side = 512});
    ASSERT_THAT(kinds(faults), ElementsAre(Kind::flat));
    EXPECT_THAT(faults.front().text,
                AllOf(HasSubstr("0.44 pixels"), HasSubstr("--height-scale"), HasSubstr("normalize")));
    EXPECT_THAT(kinds(map_faults(shallow, {.steepest_view_angle = 75, .pixels_per_side = 512})),
                ElementsAre(Kind::narrow_range));
    EXPECT_THAT(kinds(map_faults(shallow, {.height_scale = 0.5, .pixels_per_side = 512})),
                ElementsAre(Kind::narrow_range));
    EXPECT_THAT(kinds(map_faults(map_of(wave), {.steepest_view_angle = 0})), ElementsAre(Kind::flat));
}

TEST(MapFaults, FewHeightsAreStairs) {
    EXPECT_THAT(kinds(map_faults(map_of([](int x, int y) { return in_steps(wave(x, y), 5); }), {})),
                ElementsAre(Kind::few_levels));
}

TEST(MapFaults, SmoothSlopesOf8BitsAreTerracesWhereTheirEdgesShiftPixels) {
    const HeightMap terraces =
        map_of([](int x, int y) { return in_steps(0.5 + 0.6 * (wave(x / 4.0, y / 4.0) - 0.5), 255); });
    EXPECT_THAT(kinds(map_faults(terraces, {.pixels_per_side = 2048})), ElementsAre(Kind::terraces));
    EXPECT_THAT(map_faults(terraces, {.pixels_per_side = 512}), IsEmpty());
    const auto fine = [](int x, int y) { return 0.5 + 0.6 * (wave(x / 4.0, y / 4.0) - 0.5); };
    EXPECT_THAT(map_faults(map_of(fine), {.pixels_per_side = 2048}), IsEmpty());
    const HeightMap steep = map_of([](int x, int y) { return in_steps(wave(x * 4, y * 4), 255); });
    EXPECT_THAT(map_faults(steep, {.pixels_per_side = 2048}), IsEmpty());
}

TEST(MapFaults, NoiseFromTexelToTexelIsToldAndNoiseOverManyIsNot) {
    const auto white = [](int x, int y) { return random_at(1, x, y); };
    EXPECT_THAT(kinds(map_faults(map_of(white), {})), ElementsAre(Kind::noise));
    const auto on_waves = [](int x, int y) { return 0.8 * wave(x, y) + 0.15 * random_at(1, x, y); };
    EXPECT_THAT(kinds(map_faults(map_of(on_waves), {})), ElementsAre(Kind::noise));
    const auto checkerboard = [](int x, int y) { return (x + y) % 2 == 0 ? 0.2 : 0.8 - 0.2 * wave(x, y); };
    EXPECT_THAT(kinds(map_faults(map_of(checkerboard), {})), ElementsAre(Kind::noise));
    const auto of_pieces = [](int x, int y) { return random_at(1, x / 8, y / 8); };
    EXPECT_THAT(map_faults(map_of(of_pieces), {}), IsEmpty());
}

TEST(MapFaults, ASeamIsToldWhereTheMapRepeats) {
    const HeightMap ramp = map_of([](int x, int y) { return 0.8 * x / side + 0.1 * wave(x, y); });
    const std::vector<MapFault> faults = map_faults(ramp, {.repeats = true});
    ASSERT_THAT(kinds(faults), ElementsAre(Kind::seam));
    EXPECT_THAT(faults.front().text, HasSubstr("does not tile"));
    EXPECT_THAT(map_faults(ramp, {.repeats = false}), IsEmpty());
}

}  // namespace
}  // namespace reliefbench
