#include "metrics/flip.hpp"

#include "core/parallel.hpp"
#include "metrics/flip_colour.hpp"
#include "metrics/flip_rows.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace reliefbench {

namespace {

/// Equation 6: the difference of edges or points, whichever is larger.
float feature_difference(float edge_difference, float point_difference) {
    constexpr float y_range = 116;
    const float larger = edge_difference > point_difference ? edge_difference : point_difference;
    // The square root is the paper's power of q_f = 0.5.
    const float difference = std::sqrt(larger * (1 / (y_range * std::numbers::sqrt2_v<float>)));
    return difference < 1 ? difference : 1.0F;
}

/// Equation 7. Plain pointers, for only then is the loop vectorised.
void compare(const flip::SeenRow& first, const flip::SeenRow& second, float c_max, float* out, std::size_t width) {
    const float *l1 = first.l.data(), *a1 = first.a.data(), *b1 = first.b.data();
    const float *l2 = second.l.data(), *a2 = second.a.data(), *b2 = second.b.data();
    const float *edge1 = first.edge.data(), *point1 = first.point.data();
    const float *edge2 = second.edge.data(), *point2 = second.point.data();
    for (std::size_t x = 0; x < width; ++x) {
        const float colour = flip::colour_difference({l1[x], a1[x], b1[x]}, {l2[x], a2[x], b2[x]}, c_max);
        const float feature = feature_difference(std::abs(edge1[x] - edge2[x]), std::abs(point1[x] - point2[x]));
        out[x] = power(colour, 1 - feature);
    }
}

}  // namespace

int flip_reach(double pixels_per_degree) {
    return static_cast<int>(flip::make_filters(pixels_per_degree).radius);
}

Image<float> flip_map(const Image<std::array<float, 3>>& first, const Image<std::array<float, 3>>& second,
                      double pixels_per_degree) {
    assert(first.size == second.size);
    // Divides the usual heights of pictures, so that cores get equal shares.
    constexpr std::size_t strip_rows = 60;
    const flip::Filters filters = flip::make_filters(pixels_per_degree);
    const float c_max = flip::largest_colour_difference();
    Image<float> map(first.size);
    parallel_for(static_cast<std::size_t>(first.size.height), strip_rows, [&](std::size_t begin, std::size_t end) {
        flip::FilteredRows first_rows(first, filters, begin);
        flip::FilteredRows second_rows(second, filters, begin);
        flip::SeenRow a;
        flip::SeenRow b;
        for (std::size_t row = begin; row < end; ++row) {
            first_rows.next(a);
            second_rows.next(b);
            compare(a, b, c_max, &map.at(0, static_cast<int>(row)), static_cast<std::size_t>(first.size.width));
        }
    });
    return map;
}

}  // namespace reliefbench
