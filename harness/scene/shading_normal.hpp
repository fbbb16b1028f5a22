#pragma once

#include "scene/image.hpp"
#include "scene/relief.hpp"

#include <glm/vec3.hpp>

#include <array>

namespace reliefbench {

/// The slopes H·tiling·∂h/∂u and H·tiling·∂h/∂v over the base, from the derivative texture (height_derivatives()),
/// bilinear and repeating at texture coordinates tiling·(u, v).
glm::dvec2 shading_slope(const Image<std::array<float, 2>>& derivatives, const Relief& relief, double u, double v);

/// In world space, of a relief on a flat base: normalize(−H·tiling·∂h/∂u, −H·tiling·∂h/∂v, 1).
glm::dvec3 shading_normal(const Image<std::array<float, 2>>& derivatives, const Relief& relief, double u, double v);

}  // namespace reliefbench
