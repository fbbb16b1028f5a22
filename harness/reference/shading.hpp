#pragma once

#include "scene/lighting.hpp"

#include <glm/vec3.hpp>

namespace reliefbench {

/// The same function as shade() in harness/shaders/shading.glsl, in double, linear RGB; the albedo alone where lighting
/// is off. `normal` and `to_eye` are unit vectors in world space, `t` the distance along the ray (fog).
glm::dvec3 shade(const Lighting& lighting, glm::dvec3 albedo, glm::dvec3 normal, glm::dvec3 to_eye, double t,
                 double light_visibility = 1.0);

}  // namespace reliefbench
