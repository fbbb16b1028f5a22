#include "metrics/pixel_errors.hpp"

#include "scene/surface/charts.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace reliefbench {

bool is_finite_hit(const Hit& hit) {
    return hit.is_hit() && std::isfinite(hit.u) && std::isfinite(hit.v) && std::isfinite(hit.t);
}

double uv_error(const Hit& technique, const Hit& truth, const HeightMap& map, const Relief& relief,
                const glm::dvec2& period) {
    const glm::dvec2 way =
        shortest_way({static_cast<double>(technique.u) - truth.u, static_cast<double>(technique.v) - truth.v}, period);
    return std::hypot(way.x * relief.tiling * map.width(), way.y * relief.tiling * map.height());
}

double depth_error(const Hit& technique, const Hit& truth) {
    return static_cast<double>(technique.t) - truth.t;
}

double angle_between(const glm::dvec3& first, const glm::dvec3& second) {
    return glm::degrees(std::atan2(glm::length(glm::cross(first, second)), glm::dot(first, second)));
}

}  // namespace reliefbench
