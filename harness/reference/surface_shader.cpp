#include "reference/surface_shader.hpp"

namespace reliefbench {

SurfaceShader::SurfaceShader(const HeightMap& map, const Albedo& albedo, const Relief& relief, const Lighting& lighting)
    : albedo_(albedo),
      derivatives_(height_derivatives(map)),
      tiling_(relief.tiling),
      slope_scale_(relief.height_scale * relief.tiling),
      lighting_(lighting) {
    for (const DirectionalLight& light : lighting.lights)
        to_lights_.push_back(glm::normalize(light.direction));
    constexpr double max_half = 512;
    const double half = lighting.shininess / 2;
    if (half <= max_half && half == std::floor(half)) half_exponent_ = static_cast<std::uint32_t>(half);
}

}  // namespace reliefbench
