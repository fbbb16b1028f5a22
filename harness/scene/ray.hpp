#pragma once

#include <glm/vec3.hpp>

namespace reliefbench {

/// A ray with a unit direction. For perspective it starts at the eye; for parallel rays at z = 0, so that in both
/// cases the ray parameter is the t that a hit reports.
struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

}  // namespace reliefbench
