#include "scene/periodic_noise.hpp"

#include "core/random.hpp"

#include <glm/geometric.hpp>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace reliefbench {

namespace {

double fade(double x) {
    return x * x * x * (x * (x * 6 - 15) + 10);
}

/// Brings the range of two-dimensional gradient noise, ±1/√2 for unit gradients, to ±1.
constexpr double amplitude = std::numbers::sqrt2;

}  // namespace

PeriodicNoise::PeriodicNoise(int period, std::uint64_t seed) : period_(period) {
    assert(period > 0);
    gradients_.reserve(static_cast<std::size_t>(period) * period);
    for (int y = 0; y < period; ++y) {
        for (int x = 0; x < period; ++x) {
            const double angle = 2 * std::numbers::pi * random_at(seed, x, y);
            gradients_.emplace_back(std::cos(angle), std::sin(angle));
        }
    }
}

double PeriodicNoise::operator()(glm::dvec2 position) const {
    const double x = position.x * period_;
    const double y = position.y * period_;
    const double left = std::floor(x);
    const double below = std::floor(y);
    const double fx = x - left;
    const double fy = y - below;
    const auto wrap = [&](double index) {
        const int remainder = static_cast<int>(index) % period_;
        return remainder < 0 ? remainder + period_ : remainder;
    };
    const int x0 = wrap(left);
    const int x1 = x0 + 1 == period_ ? 0 : x0 + 1;
    const int y0 = wrap(below);
    const int y1 = y0 + 1 == period_ ? 0 : y0 + 1;
    const auto slope = [&](int column, int row, double dx, double dy) {
        const glm::dvec2& gradient = gradients_[static_cast<std::size_t>(row) * period_ + column];
        return gradient.x * dx + gradient.y * dy;
    };
    const double lower = std::lerp(slope(x0, y0, fx, fy), slope(x1, y0, fx - 1, fy), fade(fx));
    const double upper = std::lerp(slope(x0, y1, fx, fy - 1), slope(x1, y1, fx - 1, fy - 1), fade(fx));
    return amplitude * std::lerp(lower, upper, fade(fy));
}

FractalNoise::FractalNoise(Shape shape, std::uint64_t seed) : gain_(shape.gain) {
    Random random(seed);
    for (int octave = 0; octave < shape.octaves; ++octave) {
        const glm::dvec2 shift{random.uniform(), random.uniform()};
        octaves_.push_back({PeriodicNoise(shape.period << octave, random.next()), shift});
    }
}

double FractalNoise::operator()(glm::dvec2 position) const {
    double sum = 0;
    double total = 0;
    double weight = 1;
    for (const Octave& octave : octaves_) {
        sum += weight * octave.noise(position + octave.shift);
        total += weight;
        weight *= gain_;
    }
    return sum / total;
}

}  // namespace reliefbench
