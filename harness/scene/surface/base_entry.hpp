#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace reliefbench {

/// Of a point of a base surface: how it goes on along u and along v, in units of the patch side, and its unit normal on
/// the side that is seen. Right-handed; the first two need be neither orthogonal nor of unit length.
struct TangentFrame {
    glm::dvec3 along_u;
    glm::dvec3 along_v;
    glm::dvec3 normal;

    /// A direction of the world as multiples of the three: what a ray travels in u, in v and upwards over its length.
    glm::dvec3 from_world(const glm::dvec3& direction) const {
        const glm::dvec3 across = glm::cross(along_u, along_v);
        return glm::dvec3(glm::dot(direction, glm::cross(along_v, normal)),
                          glm::dot(direction, glm::cross(normal, along_u)), glm::dot(direction, across)) /
               glm::dot(across, normal);
    }
};

/// Where a ray enters the relief through its base surface.
struct BaseEntry {
    /// Patch coordinates.
    glm::dvec2 uv;
    /// Along the ray.
    double t = 0;
    TangentFrame frame;
};

/// A rectangle of patch coordinates.
struct PatchRegion {
    glm::dvec2 low{0, 0};
    glm::dvec2 high{1, 1};
};

}  // namespace reliefbench
