#include "metrics/error_maps.hpp"

#include "metrics/coverage.hpp"
#include "metrics/hit_errors.hpp"
#include "metrics/image_errors.hpp"
#include "metrics/ssim.hpp"
#include "scene/colour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {
namespace {

constexpr Resolution size{24, 16};

HeightMap waves() {
    Image<float> heights({32, 32});
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            heights.at(x, y) = static_cast<float>(0.5 + 0.4 * std::sin(0.4 * x) * std::cos(0.2 * y));
        }
    }
    return make_height_map(heights, HeightFormat::r16, "waves");
}

/// Every pixel hits somewhere, but some technique's and some of the truth's do not.
struct Scattered {
    HitImage technique{size};
    HitImage truth{size};
    Image<std::uint8_t> footprint{size, 1};

    Scattered() {
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const auto u = static_cast<float>(x) / 24;
                const auto v = static_cast<float>(y) / 16;
                truth.at(x, y) = {u, v, 0.5F, 1.0F};
                technique.at(x, y) = {u + 0.003F * static_cast<float>(x % 5), v, 0.5F,
                                      1.0F + 0.01F * static_cast<float>(y % 3 - 1)};
                if ((x + y) % 7 == 0) technique.at(x, y) = Hit{};
                if ((x + y) % 11 == 0) truth.at(x, y) = Hit{};
                if (x >= 20) footprint.at(x, y) = 0;
            }
        }
        technique.at(3, 3).t = std::numeric_limits<float>::infinity();
    }

    ComparedHits compared(const HeightMap& map, const Relief& relief) const {
        return {technique, truth, footprint, map, relief};
    }
};

double mean_inside(const Image<float>& map, const Image<std::uint8_t>& footprint) {
    double sum = 0;
    int count = 0;
    for (std::size_t pixel = 0; pixel < map.texels.size(); ++pixel) {
        if (footprint.texels[pixel] == 0 || std::isnan(map.texels[pixel])) continue;
        sum += map.texels[pixel];
        ++count;
    }
    return sum / count;
}

TEST(ErrorMaps, TheirMeansAreTheErrorsOfTheWhole) {
    const HeightMap map = waves();
    const Relief relief;
    const Scattered hits;
    const HitErrors errors = compare_hits(hits.compared(map, relief));
    // The maps are of floats.
    constexpr double tolerance = 1e-6;
    EXPECT_NEAR(mean_inside(uv_error_map(hits.compared(map, relief)), hits.footprint), errors.uv_texels->mean,
                tolerance);
    EXPECT_NEAR(mean_inside(depth_error_map(hits.compared(map, relief)), hits.footprint), errors.depth->mean,
                tolerance);
    EXPECT_NEAR(mean_inside(normal_error_map(hits.compared(map, relief)), hits.footprint), errors.normal_deg->mean,
                tolerance);
    EXPECT_GT(errors.normal_deg->mean, 0.1);
}

TEST(ErrorMaps, CoverageCountsWhatTheErrorsCount) {
    const Scattered hits;
    const HeightMap map = waves();
    const Relief relief;
    const HitErrors errors = compare_hits(hits.compared(map, relief));
    const Image<Coverage> coverage = coverage_map(hits.compared(map, relief));
    const auto inside = [&](Coverage wanted) {
        std::size_t count = 0;
        for (std::size_t pixel = 0; pixel < coverage.texels.size(); ++pixel) {
            count += coverage.texels[pixel] == wanted && hits.footprint.texels[pixel] != 0 ? 1 : 0;
        }
        return static_cast<double>(count);
    };
    const auto footprint = static_cast<double>(errors.footprint);
    EXPECT_EQ(inside(Coverage::both), static_cast<double>(errors.compared));
    EXPECT_EQ(inside(Coverage::missed) / footprint, errors.missed);
    EXPECT_EQ(inside(Coverage::false_hit) / footprint, errors.false_hits);
    EXPECT_EQ(inside(Coverage::missed_outside), 0);
    EXPECT_EQ(coverage.at(3, 3), Coverage::missed) << "a hit that is not finite is a miss";
    EXPECT_GT(std::count(coverage.texels.begin(), coverage.texels.end(), Coverage::missed_outside), 0);
    EXPECT_GT(inside(Coverage::neither), 0);
}

TEST(ErrorMaps, SsimOfColoursIsTheMeanOfItsChannels) {
    Image<std::array<float, 3>> first(size);
    Image<std::array<float, 3>> second(size);
    std::array<Image<double>, 3> first_channels;
    std::array<Image<double>, 3> second_channels;
    first_channels.fill(Image<double>(size));
    second_channels.fill(Image<double>(size));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double phase = 0.5 * x + 0.3 * static_cast<double>(channel) * y;
                first.at(x, y)[channel] = static_cast<float>(0.5 + 0.4 * std::sin(phase));
                second.at(x, y)[channel] = static_cast<float>(0.5 + 0.4 * std::sin(phase + 0.4));
                first_channels[channel].at(x, y) = srgb_encode(first.at(x, y)[channel]);
                second_channels[channel].at(x, y) = srgb_encode(second.at(x, y)[channel]);
            }
        }
    }
    const Image<std::uint8_t> everywhere(size, 1);
    const Image<float> map = footprint_ssim_map(first, second, {everywhere, {}});
    std::array<Image<double>, 3> of_channels;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        of_channels[channel] = ssim_map(first_channels[channel], second_channels[channel]);
    }
    for (std::size_t pixel = 0; pixel < map.texels.size(); ++pixel) {
        const double mean =
            (of_channels[0].texels[pixel] + of_channels[1].texels[pixel] + of_channels[2].texels[pixel]) / 3;
        EXPECT_NEAR(map.texels[pixel], mean, 1e-7);
    }
}

}  // namespace
}  // namespace reliefbench
