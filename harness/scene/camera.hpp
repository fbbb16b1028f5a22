#pragma once

#include "scene/image.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace reliefbench {

enum class Projection { perspective, parallel };

std::string to_string(Projection projection);

/// The camera of docs/architecture.md, "One geometry". Angles in degrees, lengths in units of the patch side.
struct Camera {
    Projection projection = Projection::perspective;
    /// θ in [0, 90): 0 is head-on. A camera in motion may pass it: −θ is θ with the azimuth turned by 180° and the
    /// picture with it.
    double view_angle = 0;
    /// φ: −90 makes the picture stand as in the file at θ = 0.
    double azimuth = -90;
    /// Eye to origin; perspective only.
    double distance = 1.5;
    /// Vertical field of view; perspective only.
    double fov = 45;

    bool operator==(const Camera&) const = default;
};

/// A ray with a unit direction. For perspective it starts at the eye; for parallel rays at z = 0, so that in both
/// cases the ray parameter is the t that a hit reports.
struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

/// Orthonormal; for perspective `eye` = distance·(sinθ·cosφ, sinθ·sinφ, cosθ), looking at the origin. For parallel
/// rays `forward` is every ray's direction and `eye` is unused.
struct CameraFrame {
    glm::dvec3 eye;
    glm::dvec3 forward;
    glm::dvec3 right;
    glm::dvec3 up;
};

CameraFrame camera_frame(const Camera& camera);

/// The rays of a picture's pixels; row 0 is the top.
class PixelRays {
public:
    PixelRays(const Camera& camera, Resolution resolution);

    /// Through the centre of pixel (i, j); i and j may be fractions.
    Ray at(double i, double j) const;

    /// The inverse: i and j of the ray that meets the point, which may lie outside the picture. Empty for a point that
    /// is not before the eye.
    std::optional<glm::dvec2> project(glm::dvec3 point) const;

private:
    bool parallel_;
    Resolution resolution_;
    CameraFrame frame_;
    /// `right` and `up` times the tangents of the half angles that the picture spans.
    glm::dvec3 across_;
    glm::dvec3 upwards_;
};

/// One ray of them.
Ray pixel_ray(const Camera& camera, Resolution resolution, double i, double j);

/// World to Vulkan clip space (y down, depth 0..1, less is nearer) with exactly the pixels of `pixel_ray`.
/// For parallel rays an oblique affine projection that slides points along the rays onto z = 0, whose unit square
/// fills the target; depth is then −z.
glm::dmat4 clip_from_world(const Camera& camera, Resolution resolution);

}  // namespace reliefbench
