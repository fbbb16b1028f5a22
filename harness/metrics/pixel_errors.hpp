#pragma once

#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/relief.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace reliefbench {

/// Errors of one pixel's hit, as docs/architecture.md defines them.

/// A technique's hit with a number that is not finite (a shader's division by zero) counts as a miss.
bool is_finite_hit(const Hit& hit);

/// Texels. u and v are never wrapped but by the chart's `period` (ComparedHits::chart_period), the shortest way: on the
/// far side of a seam the technique goes on in the coordinates of the near one.
double uv_error(const Hit& technique, const Hit& truth, const HeightMap& map, const Relief& relief,
                const glm::dvec2& period = glm::dvec2(0));

/// t − t_truth: positive = too deep.
double depth_error(const Hit& technique, const Hit& truth);

/// Degrees; accurate for small angles, which the arc cosine is not.
double angle_between(const glm::dvec3& first, const glm::dvec3& second);

}  // namespace reliefbench
