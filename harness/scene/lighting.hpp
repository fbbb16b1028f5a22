#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace reliefbench {

struct DirectionalLight {
    /// Towards the light, world space, any length but zero.
    glm::dvec3 direction{-0.5, 0.5, 1.0};
    glm::dvec3 colour{1.0, 1.0, 1.0};
    /// Half the angle under which it is seen, degrees: the sun's, and what the truth of soft shadows is made with.
    double angular_radius = 0.2665;
};

/// Linear towards `colour` with the distance t along the ray.
struct Fog {
    double start = 1;
    double range = 1;
    glm::dvec3 colour{0.5, 0.5, 0.5};
};

/// The one shading model: albedo·(ambient + Σ light·max(N·L, 0)) + Σ light·specular·max(N·Hv, 0)^shininess where
/// N·L > 0 (Blinn-Phong, Hv the half vector), then fog. Linear RGB; encoding to sRGB comes last, outside of it.
struct Lighting {
    /// At most three.
    std::vector<DirectionalLight> lights{DirectionalLight{}};
    glm::dvec3 ambient{0.2, 0.2, 0.2};
    glm::dvec3 specular{0.15, 0.15, 0.15};
    double shininess = 32;
    std::optional<Fog> fog;
    /// Off: the colour is the albedo alone.
    bool enabled = true;
    /// Linear RGB of pixels that show no relief.
    glm::dvec3 background{0.02, 0.02, 0.03};
};

}  // namespace reliefbench
