#include "metrics/flip_filters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbench::flip {

namespace {

/// Contrast sensitivity as the sum of two Gaussians, table 1: a₁, b₁, a₂, b₂.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1, 0.0047, 0, 1e-5};
constexpr Sensitivity red_green{1, 0.0053, 0, 1e-5};
constexpr Sensitivity blue_yellow{34.1, 0.04, 13.5, 0.025};
constexpr double widest_sensitivity = 0.04;
/// Width of the feature detector in degrees: the paper's w.
constexpr double detector_width = 0.082;
/// Filters end at three standard deviations.
constexpr double extent_in_deviations = 3;

/// Taps 0 … radius of an even or an odd kernel.
using HalfKernel = std::vector<double>;

/// exp(−x² / (2 σ²)), unnormalised, in pixels.
HalfKernel gaussian(std::size_t radius, double deviation) {
    HalfKernel taps;
    for (std::size_t x = 0; x <= radius; ++x) {
        const auto distance = static_cast<double>(x) / deviation;
        taps.push_back(std::exp(-distance * distance / 2));
    }
    return taps;
}

/// Of all taps of the even kernel.
double sum_of(const HalfKernel& taps) {
    double sum = -taps.front();
    for (const double tap : taps) {
        sum += 2 * tap;
    }
    return sum;
}

HalfKernel scaled(HalfKernel taps, double factor) {
    for (double& tap : taps) {
        tap *= factor;
    }
    return taps;
}

/// One of a sensitivity's two Gaussians, which sums to 1, and its volume in two dimensions.
struct SensitivityPart {
    HalfKernel kernel;
    double volume = 0;
};

/// a √(π/b) exp(−π² z / b), z in square degrees.
SensitivityPart sensitivity_part(double a, double b, double pixels_per_degree, std::size_t radius) {
    const double deviation = std::sqrt(b / 2) / std::numbers::pi * pixels_per_degree;
    const HalfKernel values = gaussian(radius, deviation);
    const double sum = sum_of(values);
    return {scaled(values, 1 / sum), a * std::sqrt(std::numbers::pi / b) * sum * sum};
}

/// Positive weights sum to 1 and negative ones to −1, those of the mirrored half included.
HalfKernel balanced(HalfKernel taps, bool even) {
    double positive = 0;
    double negative = 0;
    for (std::size_t x = 0; x < taps.size(); ++x) {
        const double mirrored = x == 0 ? 0 : (even ? taps[x] : -taps[x]);
        positive += std::max(taps[x], 0.0) + std::max(mirrored, 0.0);
        negative -= std::min(taps[x], 0.0) + std::min(mirrored, 0.0);
    }
    for (double& tap : taps) {
        tap /= tap > 0 ? positive : negative;
    }
    return taps;
}

/// Without the outer taps that a float sum does not feel; shorter kernels are filled with zeros.
template <std::size_t Even, std::size_t Odd>
FilterBank<Even, Odd> make_bank(const std::array<HalfKernel, Even + Odd>& kernels) {
    constexpr double negligible = 1e-8;
    FilterBank<Even, Odd> bank;
    for (std::size_t kernel = 0; kernel < kernels.size(); ++kernel) {
        for (std::size_t tap = 0; tap < kernels[kernel].size(); ++tap) {
            if (std::abs(kernels[kernel][tap]) >= negligible && bank.taps.size() <= tap) {
                bank.taps.resize(tap + 1);
            }
        }
    }
    for (std::size_t tap = 0; tap < bank.taps.size(); ++tap) {
        for (std::size_t kernel = 0; kernel < kernels.size(); ++kernel) {
            const HalfKernel& taps = kernels[kernel];
            bank.taps[tap][kernel] = tap < taps.size() ? static_cast<float>(taps[tap]) : 0.0F;
        }
    }
    return bank;
}

std::size_t extent(double deviation) {
    return static_cast<std::size_t>(std::ceil(extent_in_deviations * deviation));
}

/// Section 4.2: a Gaussian and its derivatives.
struct Detector {
    HalfKernel smooth, edge, point;
};

Detector make_detector(double pixels_per_degree) {
    const double deviation = 0.5 * detector_width * pixels_per_degree;
    Detector detector;
    detector.smooth = gaussian(extent(deviation), deviation);
    for (std::size_t tap = 0; tap < detector.smooth.size(); ++tap) {
        const auto x = static_cast<double>(tap);
        detector.edge.push_back(-x * detector.smooth[tap]);
        detector.point.push_back((x * x / (deviation * deviation) - 1) * detector.smooth[tap]);
    }
    detector.smooth = scaled(detector.smooth, 1 / sum_of(detector.smooth));
    detector.edge = balanced(detector.edge, false);
    detector.point = balanced(detector.point, true);
    return detector;
}

}  // namespace

Filters make_filters(double pixels_per_degree) {
    const std::size_t radius = extent(std::sqrt(widest_sensitivity / 2) / std::numbers::pi * pixels_per_degree);
    const auto part = [&](double a, double b) { return sensitivity_part(a, b, pixels_per_degree, radius); };
    // Where a₂ is 0 the second Gaussian has no share.
    static_assert(achromatic.a2 == 0 && red_green.a2 == 0);
    const SensitivityPart y = part(achromatic.a1, achromatic.b1);
    const SensitivityPart cx = part(red_green.a1, red_green.b1);
    const SensitivityPart first = part(blue_yellow.a1, blue_yellow.b1);
    const SensitivityPart second = part(blue_yellow.a2, blue_yellow.b2);
    const double volume = first.volume + second.volume;
    const Detector detector = make_detector(pixels_per_degree);

    Filters filters;
    filters.luminance = make_bank<3, 1>({y.kernel, detector.smooth, detector.point, detector.edge});
    filters.blue_yellow = make_bank<2, 0>({first.kernel, second.kernel});
    filters.blue_yellow_shares = {make_bank<1, 0>({scaled(first.kernel, first.volume / volume)}),
                                  make_bank<1, 0>({scaled(second.kernel, second.volume / volume)})};
    filters.achromatic = make_bank<1, 0>({y.kernel});
    filters.red_green = make_bank<1, 0>({cx.kernel});
    filters.smooth = make_bank<1, 0>({detector.smooth});
    filters.point_and_edge = make_bank<1, 1>({detector.point, detector.edge});
    filters.radius = std::max(radius, detector.smooth.size() - 1);
    return filters;
}

}  // namespace reliefbench::flip
