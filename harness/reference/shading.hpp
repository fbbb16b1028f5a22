#pragma once

#include "scene/lighting.hpp"

#include <glm/vec3.hpp>

namespace reliefbench {

/// The same function as shade() in harness/shaders/driver/shading.glsl, in double, linear RGB; the albedo alone where
/// lighting is off. `normal` and `to_eye` are unit vectors in world space, `t` the distance along the ray (fog),
/// `visibility` how much of each light arrives.
glm::dvec3 shade(const Lighting& lighting, glm::dvec3 albedo, glm::dvec3 normal, glm::dvec3 to_eye, double t,
                 glm::dvec3 visibility = glm::dvec3(1.0));

}  // namespace reliefbench
