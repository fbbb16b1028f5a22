#pragma once

#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/lighting.hpp"
#include "scene/relief.hpp"
#include "scene/shading_normal.hpp"

#include <glm/vec3.hpp>

namespace reliefbench {

/// The same function as shade() in harness/shaders/shading.glsl, in double, linear RGB.
/// `normal` and `to_eye` are unit vectors in world space, `t` the distance along the ray (fog).
glm::dvec3 shade(const Lighting& lighting, glm::dvec3 albedo, glm::dvec3 normal, glm::dvec3 to_eye, double t,
                 double light_visibility = 1.0);

}  // namespace reliefbench
