#include "scene/procedural.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace reliefbench {
namespace {

class Procedural : public testing::TestWithParam<std::string> {};

std::vector<std::string> names() {
    std::vector<std::string> result;
    for (const ProceduralMap& map : procedural_maps())
        result.push_back(map.name);
    return result;
}

INSTANTIATE_TEST_SUITE_P(Maps, Procedural, testing::ValuesIn(names()),
                         [](const auto& parameter) { return parameter.param; });

float texel(const Image<float>& map, int x, int y) {
    return map.at((x + map.size.width) % map.size.width, (y + map.size.height) % map.size.height);
}

TEST(ProceduralMaps, AreAtLeastThePromisedSix) {
    const auto all = names();
    for (const char* name : {"bricks", "cobbles", "rock", "waves", "spikes", "steps"}) {
        EXPECT_NE(std::find(all.begin(), all.end(), name), all.end()) << name;
    }
    for (const ProceduralMap& map : procedural_maps())
        EXPECT_FALSE(map.description.empty()) << map.name;
}

TEST_P(Procedural, FillsTheHeightRange) {
    for (const Resolution size : {Resolution{128, 128}, Resolution{100, 61}}) {
        const Image<float> map = generate_height_map(GetParam(), size, 1);
        ASSERT_EQ(map.size, size);
        ASSERT_EQ(map.texels.size(), size.pixels());
        const auto [smallest, largest] = std::minmax_element(map.texels.begin(), map.texels.end());
        EXPECT_EQ(*smallest, 0);
        EXPECT_EQ(*largest, 1);
    }
}

TEST_P(Procedural, DependsOnTheSeedAndOnNothingElse) {
    const Resolution size{60, 40};
    const Image<float> map = generate_height_map(GetParam(), size, 7);
    EXPECT_EQ(generate_height_map(GetParam(), size, 7).texels, map.texels);
    EXPECT_NE(generate_height_map(GetParam(), size, 8).texels, map.texels);
}

/// The mean height difference between column `column` and the one before it.
double mean_jump_before_column(const Image<float>& map, int column) {
    double sum = 0;
    for (int y = 0; y < map.size.height; ++y)
        sum += std::abs(texel(map, column, y) - texel(map, column - 1, y));
    return sum / map.size.height;
}

double mean_jump_before_row(const Image<float>& map, int row) {
    double sum = 0;
    for (int x = 0; x < map.size.width; ++x)
        sum += std::abs(texel(map, x, row) - texel(map, x, row - 1));
    return sum / map.size.width;
}

TEST_P(Procedural, HasNoSeam) {
    for (const Resolution size : {Resolution{128, 128}, Resolution{150, 97}}) {
        const Image<float> map = generate_height_map(GetParam(), size, 3);
        // Across the border the map jumps about as much as right beside it. A seam would jump by the mean difference
        // of unrelated heights, which is several times as much on all but the thinnest features.
        double beside_column = 0, beside_row = 0;
        for (const int offset : {-3, -2, -1, 1, 2, 3}) {
            beside_column = std::max(beside_column, mean_jump_before_column(map, offset));
            beside_row = std::max(beside_row, mean_jump_before_row(map, offset));
        }
        EXPECT_LE(mean_jump_before_column(map, 0), 1.5 * beside_column);
        EXPECT_LE(mean_jump_before_row(map, 0), 1.5 * beside_row);
    }
}

TEST_P(Procedural, TakesTheSmallestSizes) {
    for (const Resolution size : {Resolution{1, 1}, Resolution{1, 7}, Resolution{3, 2}}) {
        for (const float height : generate_height_map(GetParam(), size, 1).texels) {
            EXPECT_GE(height, 0);
            EXPECT_LE(height, 1);
        }
    }
}

TEST(ProceduralMaps, WavesAreSmooth) {
    // No texel departs from the parabola through its neighbours by more than a smooth function does: halving the
    // spacing must divide second differences by about four.
    const auto largest_second_difference = [](int side) {
        const Image<float> map = generate_height_map("waves", {side, side}, 1);
        float largest = 0;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const float middle = 2 * map.at(x, y);
                largest = std::max(largest, std::abs(texel(map, x - 1, y) + texel(map, x + 1, y) - middle));
                largest = std::max(largest, std::abs(texel(map, x, y - 1) + texel(map, x, y + 1) - middle));
            }
        }
        return largest;
    };
    // Four to second order; the tolerance covers where the texels fall on the sharpest crest.
    EXPECT_NEAR(largest_second_difference(128) / largest_second_difference(256), 4, 0.2);
}

TEST(ProceduralMaps, SpikesStayThinInTexelsAtAnySize) {
    for (const Resolution size : {Resolution{48, 48}, Resolution{256, 256}, Resolution{500, 300}}) {
        const Image<float> map = generate_height_map("spikes", size, 1);
        int high = 0, thick = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (texel(map, x, y) < 0.4f) continue;
                ++high;
                // Thick: inside a square of 4×4 high texels.
                bool filled = true;
                for (int dy = 0; dy < 4; ++dy) {
                    for (int dx = 0; dx < 4; ++dx)
                        filled = filled && texel(map, x + dx, y + dy) >= 0.4f;
                }
                thick += filled;
            }
        }
        EXPECT_GT(high, 5);
        EXPECT_LT(high, 0.1 * static_cast<double>(size.pixels()));
        EXPECT_EQ(thick, 0);
    }
}

TEST(ProceduralMaps, StepsAreTerracesAndCliffs) {
    const Image<float> map = generate_height_map("steps", {256, 256}, 1);
    const std::set<float> levels(map.texels.begin(), map.texels.end());
    EXPECT_GE(levels.size(), 5u);
    EXPECT_LE(levels.size(), 8u);
    int flat = 0, cliffs = 0;
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            const float jump = std::abs(texel(map, x + 1, y) - texel(map, x, y));
            flat += jump == 0;
            cliffs += jump > 0.1f;
        }
    }
    EXPECT_EQ(flat + cliffs, 256 * 256);
    EXPECT_GT(cliffs, 256);
}

TEST(ProceduralMaps, BricksAreFacesAboveJoints) {
    const Image<float> map = generate_height_map("bricks", {256, 256}, 1);
    const auto share = [&](float low, float high) {
        const auto count = std::count_if(map.texels.begin(), map.texels.end(),
                                         [&](float height) { return height >= low && height < high; });
        return static_cast<double>(count) / static_cast<double>(map.texels.size());
    };
    EXPECT_GT(share(0.0f, 0.3f), 0.15);
    EXPECT_GT(share(0.6f, 1.01f), 0.5);
    EXPECT_LT(share(0.3f, 0.6f), 0.25);
}

}  // namespace
}  // namespace reliefbench
