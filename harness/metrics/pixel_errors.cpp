#include "metrics/pixel_errors.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace reliefbench {

namespace {

double shortest(double difference, double period) {
    return period > 0 ? std::remainder(difference, period) : difference;
}

}  // namespace

bool is_finite_hit(const Hit& hit) {
    return hit.is_hit() && std::isfinite(hit.u) && std::isfinite(hit.v) && std::isfinite(hit.t);
}

double uv_error(const Hit& technique, const Hit& truth, const HeightMap& map, const Relief& relief,
                const glm::dvec2& period) {
    const double du = shortest(static_cast<double>(technique.u) - truth.u, period.x);
    const double dv = shortest(static_cast<double>(technique.v) - truth.v, period.y);
    return std::hypot(du * relief.tiling * map.width(), dv * relief.tiling * map.height());
}

double depth_error(const Hit& technique, const Hit& truth) {
    return static_cast<double>(technique.t) - truth.t;
}

double angle_between(const glm::dvec3& first, const glm::dvec3& second) {
    return glm::degrees(std::atan2(glm::length(glm::cross(first, second)), glm::dot(first, second)));
}

}  // namespace reliefbench
