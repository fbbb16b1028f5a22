#pragma once

#include "scene/lighting.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>

namespace reliefbench {

/// Directions within the angular radius of a light, uniform over their solid angle.
class LightDisc {
public:
    explicit LightDisc(const DirectionalLight& light)
        : to_centre_(glm::normalize(light.direction)),
          // 1 − cos r without cancellation.
          height_(2 * std::pow(std::sin(glm::radians(light.angular_radius) / 2), 2)) {
        const glm::dvec3 aside = std::abs(to_centre_.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        tangent_ = glm::normalize(glm::cross(to_centre_, aside));
        bitangent_ = glm::cross(to_centre_, tangent_);
    }

    /// A unit vector.
    const glm::dvec3& to_centre() const { return to_centre_; }

    /// Of a point of the unit square.
    glm::dvec3 direction(glm::dvec2 point) const {
        const double below_pole = point.x * height_;
        const double sine = std::sqrt(below_pole * (2 - below_pole));
        const double turn = 2 * std::numbers::pi * point.y;
        return to_centre_ * (1 - below_pole) + sine * (std::cos(turn) * tangent_ + std::sin(turn) * bitangent_);
    }

private:
    glm::dvec3 to_centre_;
    double height_;
    glm::dvec3 tangent_;
    glm::dvec3 bitangent_;
};

}  // namespace reliefbench
