#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace reliefbench {

/// Gradient noise (Perlin 2002: quintic fade) on a lattice of `period`² cells over the unit square, repeating with
/// period 1 in u and v. Values lie in about [−1, 1], with mean 0.
class PeriodicNoise {
public:
    PeriodicNoise(int period, std::uint64_t seed);

    double operator()(glm::dvec2 position) const;

private:
    int period_;
    std::vector<glm::dvec2> gradients_;
};

/// Sum of octaves of PeriodicNoise, each at twice the frequency and `gain` times the amplitude of the one before.
class FractalNoise {
public:
    struct Shape {
        /// Lattice cells per unit of the first octave.
        int period = 4;
        int octaves = 4;
        double gain = 0.5;
    };

    FractalNoise(Shape shape, std::uint64_t seed);

    /// In about [−1, 1]: divided by the sum of the amplitudes.
    double operator()(glm::dvec2 position) const;
    /// In [0, 1], with sharp crests where an octave changes its sign (Musgrave's ridged fractal, unweighted).
    double ridged(glm::dvec2 position) const;

private:
    std::vector<PeriodicNoise> octaves_;
    double gain_;
};

}  // namespace reliefbench
