#include "scene/shading_normal.hpp"

#include <glm/vec2.hpp>

#include <cmath>

namespace reliefbench {

namespace {

/// The two texels around a texture coordinate, and how far towards the second it lies.
struct Neighbours {
    int first = 0;
    int second = 0;
    double fraction = 0;
};

Neighbours neighbours(double coordinate, int count) {
    const double position = (coordinate - std::floor(coordinate)) * count - 0.5;
    const double below = std::floor(position);
    const int first = (static_cast<int>(below) + count) % count;
    return {first, (first + 1) % count, position - below};
}

}  // namespace

glm::dvec2 shading_slope(const Image<std::array<float, 2>>& derivatives, const Relief& relief, double u, double v) {
    const Neighbours x = neighbours(relief.tiling * u, derivatives.size.width);
    const Neighbours y = neighbours(relief.tiling * v, derivatives.size.height);
    const auto texel = [&](int column, int row) {
        const std::array<float, 2>& stored = derivatives.at(column, row);
        return glm::dvec2(stored[0], stored[1]);
    };
    const auto along_row = [&](int row) {
        return texel(x.first, row) * (1 - x.fraction) + texel(x.second, row) * x.fraction;
    };
    const glm::dvec2 slope = along_row(y.first) * (1 - y.fraction) + along_row(y.second) * y.fraction;
    const double to_world = relief.height_scale * relief.tiling;
    return to_world * slope;
}

glm::dvec3 shading_normal(const Image<std::array<float, 2>>& derivatives, const Relief& relief, double u, double v) {
    return relief_normal(flat_base(relief.base), {u, v}, shading_slope(derivatives, relief, u, v));
}

}  // namespace reliefbench
