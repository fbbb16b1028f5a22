#include "reference/texel_polygon.hpp"

#include <glm/common.hpp>

namespace reliefbench {

namespace {

/// The part where sign·(coordinate − border) ≤ 0.
TexelPolygon cut(const TexelPolygon& polygon, int axis, double border, double sign) {
    TexelPolygon left;
    for (std::size_t index = 0; index < polygon.count; ++index) {
        const glm::dvec2 from = polygon.corners[index];
        const glm::dvec2 to = polygon.corners[(index + 1) % polygon.count];
        const double from_beyond = sign * (from[axis] - border);
        const double to_beyond = sign * (to[axis] - border);
        if (from_beyond <= 0) left.add(from);
        if ((from_beyond < 0 && to_beyond > 0) || (from_beyond > 0 && to_beyond < 0))
            left.add(from + (to - from) * (from_beyond / (from_beyond - to_beyond)));
    }
    return left;
}

}  // namespace

TexelRect texel_bounds(const Prism& prism) {
    const auto corners = prism.texel_corners();
    return {glm::min(glm::min(corners[0], corners[1]), corners[2]),
            glm::max(glm::max(corners[0], corners[1]), corners[2])};
}

TexelPolygon triangle_in_rect(const Prism& prism, const TexelRect& rect) {
    TexelPolygon polygon;
    for (const glm::dvec2& corner : prism.texel_corners())
        polygon.add(corner);
    for (int axis = 0; axis < 2; ++axis) {
        polygon = cut(polygon, axis, rect.low[axis], -1);
        polygon = cut(polygon, axis, rect.high[axis], 1);
    }
    return polygon;
}

}  // namespace reliefbench
