#pragma once

#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/relief.hpp"

#include <glm/vec3.hpp>

namespace reliefbench {

/// Errors of one pixel's hit, as docs/architecture.md defines them.

/// A technique's hit with a number that is not finite (a shader's division by zero) counts as a miss.
bool is_finite_hit(const Hit& hit);

/// Texels; u and v are never wrapped.
double uv_error(const Hit& technique, const Hit& truth, const HeightMap& map, const Relief& relief);

/// t − t_truth: positive = too deep.
double depth_error(const Hit& technique, const Hit& truth);

/// Degrees; accurate for small angles, which the arc cosine is not.
double angle_between(const glm::dvec3& first, const glm::dvec3& second);

}  // namespace reliefbench
