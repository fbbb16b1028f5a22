#include "core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

using namespace reliefbench;

namespace {

TEST(Random, IsSplitMix64) {
    // The reference implementation's first numbers for these seeds.
    Random zero(0);
    EXPECT_EQ(zero.next(), 0xe220a8397b1dcdafu);
    Random other(1234567);
    EXPECT_EQ(other.next(), 6457827717110365317u);
    EXPECT_EQ(other.next(), 3203168211198807973u);
    EXPECT_EQ(other.next(), 9817491932198370423u);
}

TEST(Random, UniformStaysInItsRangeAndFillsIt) {
    Random random(7);
    double smallest = 1;
    double largest = 0;
    double sum = 0;
    for (int i = 0; i < 100000; ++i) {
        const double value = random.uniform();
        smallest = std::min(smallest, value);
        largest = std::max(largest, value);
        sum += value;
    }
    EXPECT_GE(smallest, 0);
    EXPECT_LT(largest, 1);
    EXPECT_LT(smallest, 0.001);
    EXPECT_GT(largest, 0.999);
    EXPECT_NEAR(sum / 100000, 0.5, 0.005);  // five standard deviations
}

TEST(Random, BelowIsEven) {
    Random random(7);
    std::array<int, 3> counts{};
    for (int i = 0; i < 30000; ++i) {
        ++counts.at(random.below(3));
    }
    for (const int count : counts) {
        EXPECT_NEAR(count, 10000, 410);  // five standard deviations
    }
    EXPECT_EQ(random.below(1), 0u);
}

TEST(Random, ShuffleReachesEveryOrderAndIsSeeded) {
    std::set<std::vector<int>> orders;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        std::vector<int> values{1, 2, 3};
        std::vector<int> again{1, 2, 3};
        Random(seed).shuffle(std::span(values));
        Random(seed).shuffle(std::span(again));
        EXPECT_EQ(values, again);
        orders.insert(values);
    }
    EXPECT_EQ(orders.size(), 6u);
}

TEST(Random, HashedNumbersDependOnSeedAndBothCoordinates) {
    std::set<double> numbers;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        for (int x = -4; x < 4; ++x) {
            for (int y = -4; y < 4; ++y) {
                const double number = random_at(seed, x, y);
                EXPECT_EQ(number, random_at(seed, x, y));
                EXPECT_GE(number, 0);
                EXPECT_LT(number, 1);
                numbers.insert(number);
            }
        }
    }
    EXPECT_EQ(numbers.size(), 4u * 8u * 8u);
}

}  // namespace
