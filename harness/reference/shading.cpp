#include "reference/shading.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace reliefbench {

glm::dvec3 shade(const Lighting& lighting, glm::dvec3 albedo, glm::dvec3 normal, glm::dvec3 to_eye, double t,
                 glm::dvec3 visibility) {
    if (!lighting.enabled) return albedo;
    glm::dvec3 diffuse = lighting.ambient;
    glm::dvec3 specular{0.0};
    for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
        const DirectionalLight& light = lighting.lights[i];
        const glm::dvec3 to_light = glm::normalize(light.direction);
        const glm::dvec3 arriving = light.colour * visibility[static_cast<glm::length_t>(i)];
        const double n_dot_l = glm::dot(normal, to_light);
        if (n_dot_l <= 0) continue;
        diffuse += arriving * n_dot_l;
        const double n_dot_h = glm::dot(normal, glm::normalize(to_light + to_eye));
        if (n_dot_h > 0) specular += arriving * lighting.specular * std::pow(n_dot_h, lighting.shininess);
    }
    const glm::dvec3 colour = albedo * diffuse + specular;
    if (!lighting.fog) return colour;
    const Fog& fog = *lighting.fog;
    return glm::mix(colour, fog.colour, glm::clamp((t - fog.start) / fog.range, 0.0, 1.0));
}

}  // namespace reliefbench
