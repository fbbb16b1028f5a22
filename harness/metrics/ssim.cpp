#include "metrics/ssim.hpp"

#include "core/parallel.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace reliefbench {

namespace {

constexpr int radius = ssim_reach;
constexpr double deviation = 1.5;
/// C₁ and C₂ of the paper for values of range 1.
constexpr double c1 = 0.01 * 0.01;
constexpr double c2 = 0.03 * 0.03;

using Weights = std::array<double, 2 * radius + 1>;

Weights gaussian_weights() {
    Weights weights{};
    double sum = 0;
    for (int x = -radius; x <= radius; ++x) {
        double& weight = weights[static_cast<std::size_t>(x + radius)];
        weight = std::exp(-x * x / (2 * deviation * deviation));
        sum += weight;
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

/// The index inside an axis of `count` texels that mirrors to `index`.
int mirrored(int index, int count) {
    const int period = 2 * count;
    const int wrapped = (index % period + period) % period;
    return wrapped < count ? wrapped : period - 1 - wrapped;
}

/// Window-weighted sums of one pixel: both values, their squares and their product.
struct Moments {
    double first = 0, second = 0, first_squared = 0, second_squared = 0, product = 0;

    void add(double weight, const Moments& other) {
        first += weight * other.first;
        second += weight * other.second;
        first_squared += weight * other.first_squared;
        second_squared += weight * other.second_squared;
        product += weight * other.product;
    }
};

Moments moments_of(double first, double second) {
    return {first, second, first * first, second * second, first * second};
}

double similarity(const Moments& mean) {
    const double first_variance = mean.first_squared - mean.first * mean.first;
    const double second_variance = mean.second_squared - mean.second * mean.second;
    const double covariance = mean.product - mean.first * mean.second;
    return (2 * mean.first * mean.second + c1) * (2 * covariance + c2) /
           ((mean.first * mean.first + mean.second * mean.second + c1) * (first_variance + second_variance + c2));
}

}  // namespace

Image<double> ssim_map(const Image<double>& first, const Image<double>& second) {
    assert(first.size == second.size);
    constexpr std::size_t strip_rows = 16;
    const Weights weights = gaussian_weights();
    const int width = first.size.width;
    const int height = first.size.height;
    Image<Moments> along_y(first.size);
    Image<double> map(first.size);
    const auto rows = static_cast<std::size_t>(height);
    parallel_for(rows, strip_rows, [&](std::size_t begin, std::size_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int tap = -radius; tap <= radius; ++tap) {
                const int source = mirrored(y + tap, height);
                for (int x = 0; x < width; ++x) {
                    along_y.at(x, y).add(weights[static_cast<std::size_t>(tap + radius)],
                                         moments_of(first.at(x, source), second.at(x, source)));
                }
            }
        }
    });
    parallel_for(rows, strip_rows, [&](std::size_t begin, std::size_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            for (int x = 0; x < width; ++x) {
                Moments mean;
                for (int tap = -radius; tap <= radius; ++tap) {
                    mean.add(weights[static_cast<std::size_t>(tap + radius)], along_y.at(mirrored(x + tap, width), y));
                }
                map.at(x, y) = similarity(mean);
            }
        }
    });
    return map;
}

}  // namespace reliefbench
