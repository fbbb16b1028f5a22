#include "metrics/ssim.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace reliefbench {
namespace {

struct Waves {
    Image<double> first{Resolution{24, 17}};
    Image<double> second{Resolution{24, 17}};

    Waves() {
        for (int y = 0; y < first.size.height; ++y) {
            for (int x = 0; x < first.size.width; ++x) {
                first.at(x, y) = 0.5 + 0.4 * std::sin(0.7 * x + 0.2 * y);
                second.at(x, y) = 0.5 + 0.4 * std::sin(0.7 * x + 0.2 * y + 0.3) * std::cos(0.1 * y);
            }
        }
    }
};

TEST(Ssim, AgreesWithScikitImage) {
    // scikit-image 0.19: structural_similarity(first, second, gaussian_weights=True, sigma=1.5,
    // use_sample_covariance=False, data_range=1, full=True). Both work in double.
    constexpr double tolerance = 1e-12;
    const Waves waves;
    const Image<double> map = ssim_map(waves.first, waves.second);
    double sum = 0;
    for (const double value : map.texels) {
        sum += value;
    }
    EXPECT_NEAR(sum / static_cast<double>(map.texels.size()), 0.71200258332439, tolerance);
    EXPECT_NEAR(map.at(0, 0), 0.8898497746075374, tolerance);
    EXPECT_NEAR(map.at(12, 8), 0.8586345060932277, tolerance);
    EXPECT_NEAR(map.at(23, 16), 0.10685560654077368, tolerance);
    EXPECT_NEAR(map.at(5, 1), 0.9465844360859472, tolerance);
    EXPECT_NEAR(map.at(23, 0), 0.9680261483167037, tolerance);
}

TEST(Ssim, ImagesSmallerThanTheWindowAreMirroredMoreThanOnce) {
    const Resolution size{2, 1};
    Image<double> first(size);
    first.texels = {0, 1};
    Image<double> second(size);
    second.texels = {1, 0};
    const Image<double> map = ssim_map(first, second);
    EXPECT_NEAR(map.at(0, 0), map.at(1, 0), 1e-12);
    EXPECT_LT(map.at(0, 0), 0);
}

}  // namespace
}  // namespace reliefbench
