#pragma once

#include "reference/prism.hpp"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>

namespace reliefbench {

/// In texels of a chart (Prism).
struct TexelRect {
    glm::dvec2 low;
    glm::dvec2 high;
};

/// Convex: the part of a triangle in a rectangle has at most the triangle's corners and one for each side it is cut by.
struct TexelPolygon {
    static constexpr std::size_t max_corners = 8;
    std::array<glm::dvec2, max_corners> corners;
    std::size_t count = 0;

    void add(glm::dvec2 corner) { corners[count++] = corner; }
};

TexelRect texel_bounds(const Prism& prism);

/// The prism's triangle in the rectangle, its corners in the order of the triangle's; fewer than three where nothing
/// is.
TexelPolygon triangle_in_rect(const Prism& prism, const TexelRect& rect);

}  // namespace reliefbench
