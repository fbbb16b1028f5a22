#include "metrics/flip.hpp"

#include "patterns.hpp"
#include "scene/colour.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace reliefbench {
namespace {

using Colour = std::array<float, 3>;

/// From 8-bit sRGB.
Colour from_srgb(int red, int green, int blue) {
    const auto linear = [](int value) { return static_cast<float>(srgb_decode(value / 255.0)); };
    return {linear(red), linear(green), linear(blue)};
}

double mean(const Image<float>& map) {
    double sum = 0;
    for (const float value : map.texels) {
        sum += value;
    }
    return sum / static_cast<double>(map.texels.size());
}

struct UniformPair {
    Colour first;
    Colour second;
    double difference;
};

class UniformImages : public testing::TestWithParam<UniformPair> {};

// Made with the authors' tool on 128x128 images of 8-bit sRGB, which are given to five or six digits.
TEST_P(UniformImages, DifferAsInTheAuthorsTool) {
    const auto& [first, second, difference] = GetParam();
    const Resolution size{128, 128};
    const Image<float> map = flip_map(Image<Colour>(size, first), Image<Colour>(size, second));
    for (const float value : map.texels) {
        EXPECT_NEAR(value, difference, 5e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(Flip, UniformImages,
                         testing::Values(UniformPair{from_srgb(0, 0, 0), from_srgb(255, 255, 255), 0.967388},
                                         UniformPair{from_srgb(0, 255, 0), from_srgb(0, 0, 255), 1},
                                         UniformPair{from_srgb(255, 0, 0), from_srgb(0, 255, 0), 0.986665},
                                         UniformPair{from_srgb(128, 128, 128), from_srgb(144, 144, 144), 0.206491}));

TEST(Flip, FiltersAndFeaturesAreThoseOfThePaper) {
    // Computed in double from the paper's equations with SciPy's direct two-dimensional convolution; ours is in float.
    constexpr double tolerance = 5e-6;
    const Patterns patterns;
    const Image<float> map = flip_map(patterns.first, patterns.second);
    EXPECT_NEAR(mean(map), 0.4769039, tolerance);
    EXPECT_NEAR(map.at(0, 0), 0.3938796, tolerance);
    EXPECT_NEAR(map.at(20, 15), 0.3273081, tolerance);
    EXPECT_NEAR(map.at(39, 29), 0.9147459, tolerance);
    EXPECT_NEAR(map.at(33, 4), 0.4859516, tolerance);
    EXPECT_NEAR(map.at(7, 22), 0.5601320, tolerance);
}

TEST(Flip, IdenticalImagesDoNotDiffer) {
    const Patterns patterns;
    for (const float value : flip_map(patterns.first, patterns.first).texels) {
        EXPECT_EQ(value, 0);
    }
}

TEST(Flip, TheOrderOfTheImagesDoesNotMatter) {
    const Patterns patterns;
    EXPECT_EQ(flip_map(patterns.first, patterns.second).texels, flip_map(patterns.second, patterns.first).texels);
}

TEST(Flip, WhatNoDisplayShowsIsClamped) {
    const Resolution size{8, 8};
    const Image<float> map = flip_map(Image<Colour>(size, {1, 1, 1}), Image<Colour>(size, {7, 2, 1}));
    EXPECT_EQ(mean(map), 0);
}

TEST(Flip, FromFartherAwayFineDetailDiffersLess) {
    const Patterns patterns;
    const double near = mean(flip_map(patterns.first, patterns.second));
    const double far = mean(flip_map(patterns.first, patterns.second, 4 * flip_pixels_per_degree));
    EXPECT_LT(far, near);
}

}  // namespace
}  // namespace reliefbench
