#pragma once

#include "scene/image.hpp"
#include "scene/relief.hpp"

#include <glm/vec3.hpp>

#include <array>

namespace reliefbench {

/// normalize(−H·tiling·∂h/∂u, −H·tiling·∂h/∂v, 1) from the derivative texture (height_derivatives()), bilinear and
/// repeating at texture coordinates tiling·(u, v).
glm::dvec3 shading_normal(const Image<std::array<float, 2>>& derivatives, const Relief& relief, double u, double v);

}  // namespace reliefbench
