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

/// Sum of octaves of PeriodicNoise, each at twice the frequency and `gain` times the amplitude of the one before,
/// shifted at random so that the octaves' lattices, where gradient noise is zero, do not coincide.
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

private:
    struct Octave {
        PeriodicNoise noise;
        glm::dvec2 shift;
    };
    std::vector<Octave> octaves_;
    double gain_;
};

}  // namespace reliefbench
