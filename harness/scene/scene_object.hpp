#pragma once

#include "scene/camera.hpp"

#include <glm/vec3.hpp>

#include <optional>

namespace reliefbench {

/// A solid that stands in the relief, so that it is seen whether a technique's depth lets both cut through each other
/// rightly. World coordinates.
struct SceneObject {
    enum class Shape { sphere, box };

    Shape shape = Shape::sphere;
    glm::dvec3 centre{0, 0, 0};
    /// Sphere only; > 0.
    double radius = 0.15;
    /// Box only, along the world's axes; each > 0.
    glm::dvec3 half_size{0.15, 0.15, 0.15};
    /// Albedo, linear RGB.
    glm::dvec3 colour{0.6, 0.08, 0.05};
};

struct ObjectHit {
    /// Along the ray as a relief's t; of parallel rays, which come from beyond their origin, it may be negative.
    double t = 0;
    /// Outward.
    glm::dvec3 normal;
};

/// The first point of the object that the ray of a camera of this projection meets.
std::optional<ObjectHit> intersect(const SceneObject& object, const Ray& ray, Projection projection);

/// What a pixel shows.
enum class Front : unsigned char { nothing, relief, object };

}  // namespace reliefbench
