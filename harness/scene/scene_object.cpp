#include "scene/scene_object.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::optional<ObjectHit> intersect_sphere(const SceneObject& sphere, const Ray& ray, double from) {
    const glm::dvec3 to_centre = sphere.centre - ray.origin;
    const double nearest = glm::dot(to_centre, ray.direction);
    const glm::dvec3 aside = to_centre - nearest * ray.direction;
    const double half_chord_squared = sphere.radius * sphere.radius - glm::dot(aside, aside);
    if (half_chord_squared < 0) return std::nullopt;
    const double t = nearest - std::sqrt(half_chord_squared);
    if (t < from) return std::nullopt;
    return ObjectHit{t, (ray.origin + t * ray.direction - sphere.centre) / sphere.radius};
}

/// By slabs (Kay & Kajiya 1986).
std::optional<ObjectHit> intersect_box(const SceneObject& box, const Ray& ray, double from) {
    double enter = -infinity;
    double leave = infinity;
    glm::dvec3 normal{0};
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double low = box.centre[axis] - box.half_size[axis] - ray.origin[axis];
        const double high = box.centre[axis] + box.half_size[axis] - ray.origin[axis];
        if (ray.direction[axis] == 0) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        const bool forward = ray.direction[axis] > 0;
        const double first = (forward ? low : high) / ray.direction[axis];
        leave = std::min(leave, (forward ? high : low) / ray.direction[axis]);
        if (first > enter) {
            enter = first;
            normal = glm::dvec3(0);
            normal[axis] = forward ? -1 : 1;
        }
    }
    if (enter > leave || enter < from) return std::nullopt;
    return ObjectHit{enter, normal};
}

}  // namespace

std::optional<ObjectHit> intersect(const SceneObject& object, const Ray& ray, Projection projection) {
    const double from = projection == Projection::parallel ? -infinity : 0;
    return object.shape == SceneObject::Shape::sphere ? intersect_sphere(object, ray, from)
                                                      : intersect_box(object, ray, from);
}

}  // namespace reliefbench
