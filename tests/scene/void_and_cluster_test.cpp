#include "scene/void_and_cluster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

namespace reliefbench {
namespace {

constexpr int side = 64;

const Image<std::uint16_t>& noise() {
    static const Image<std::uint16_t> made = void_and_cluster(side, 1.5);
    return made;
}

/// Of a wave with so many periods along each axis, in parts of the mean energy of white noise.
double energy(const Image<std::uint16_t>& ranks, int across, int up) {
    std::complex<double> sum = 0;
    const auto texels = static_cast<double>(ranks.texels.size());
    for (int y = 0; y < ranks.size.height; ++y) {
        for (int x = 0; x < ranks.size.width; ++x)
            sum += (ranks.at(x, y) / texels - 0.5) *
                   std::polar(1.0, -2 * std::numbers::pi * (across * x + up * y) / ranks.size.width);
    }
    constexpr double variance = 1.0 / 12;
    return std::norm(sum) / (texels * variance);
}

TEST(VoidAndCluster, HasEachRankOnce) {
    std::vector<std::uint16_t> ranks = noise().texels;
    std::ranges::sort(ranks);
    std::vector<std::uint16_t> expected(side * side);
    std::iota(expected.begin(), expected.end(), std::uint16_t{0});
    EXPECT_EQ(ranks, expected);
}

// A wave of few periods sees the border as any other place: noise that did not wrap around would have energy there.
TEST(VoidAndCluster, HasNoLowFrequenciesAndWrapsAround) {
    for (int up = -8; up <= 8; ++up) {
        for (int across = 0; across <= 8; ++across) {
            if ((across == 0 && up <= 0) || std::hypot(across, up) > 8) continue;
            EXPECT_LT(energy(noise(), across, up), 0.01) << across << ", " << up;
        }
    }
    // What is missing there is in the high ones.
    double high = 0;
    for (int across = 24; across < 32; ++across)
        high += energy(noise(), across, across - 20) / 8;
    EXPECT_GT(high, 1);
}

TEST(VoidAndCluster, PointsBelowAnyRankLieApart) {
    // Of n points spread evenly over 64 x 64 texels none is nearer to the next than about 64 / sqrt(n); half of that is
    // held, where whole texels leave room for it.
    for (const int points : {32, 64, 128, 256}) {
        std::vector<int> places;
        for (int i = 0; i < side * side; ++i) {
            if (noise().texels[static_cast<std::size_t>(i)] < points) places.push_back(i);
        }
        double nearest = side;
        for (const int a : places) {
            for (const int b : places) {
                if (a == b) continue;
                const auto apart = [](int distance) { return std::min(std::abs(distance), side - std::abs(distance)); };
                nearest = std::min(nearest, std::hypot(apart(a % side - b % side), apart(a / side - b / side)));
            }
        }
        EXPECT_GT(nearest, 0.4 * side / std::sqrt(points)) << points;
    }
}

TEST(VoidAndCluster, IsTheSameEachTimeAndOfOtherSizes) {
    EXPECT_EQ(void_and_cluster(side, 1.5).texels, noise().texels);
    std::vector<std::uint16_t> small = void_and_cluster(8, 1.5).texels;
    std::ranges::sort(small);
    for (std::size_t i = 0; i < small.size(); ++i)
        EXPECT_EQ(small[i], i);
}

}  // namespace
}  // namespace reliefbench
