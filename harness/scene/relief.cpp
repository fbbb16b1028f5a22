#include "scene/relief.hpp"

namespace reliefbench {

std::string to_string(Boundary boundary) {
    return boundary == Boundary::clip ? "clip" : "repeat";
}

std::optional<glm::dvec2> footprint_entry(const Ray& ray) {
    if (ray.direction.z >= 0 || ray.origin.z < 0) return std::nullopt;
    const double t = -ray.origin.z / ray.direction.z;
    const glm::dvec2 entry{ray.origin.x + t * ray.direction.x + 0.5, ray.origin.y + t * ray.direction.y + 0.5};
    if (entry.x < 0 || entry.x > 1 || entry.y < 0 || entry.y > 1) return std::nullopt;
    return entry;
}

}  // namespace reliefbench
