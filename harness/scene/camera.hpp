#pragma once

#include "scene/image.hpp"
#include "scene/ray.hpp"

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
    /// How far beside the pixels' centres their rays run, to the right and downwards, as fractions of the picture's
    /// width and height: a frame of a sequence has another one than the next.
    glm::dvec2 shift{0, 0};
    /// z of the point that it looks at, and of the plane that parallel rays fill the picture in: where the polygon lies
    /// (set_polygon_height in scene/relief.hpp).
    double target_height = 0;

    bool operator==(const Camera&) const = default;
};

/// The shift of a frame of a still sequence of `frames`, at most half a pixel: of their Halton points to the bases
/// 2 and 3, from the first one on, those less their mean, so that a sequence's mean picture lies where one without a
/// shift does (engines take ½ from each: of 16 points 0.05 pixels apart). Of several samples, each of which has a row
/// and a column of its pixel to itself, each stays in them: the shift is as many times shorter, and no sample leaves
/// its pixel.
glm::dvec2 frame_shift(int frame, int frames, Resolution resolution, int samples_per_pixel = 1);

/// Orthonormal; for perspective `eye` = distance·(sinθ·cosφ, sinθ·sinφ, cosθ) from what it looks at. For parallel
/// rays `forward` is every ray's direction and `eye` is unused.
struct CameraFrame {
    glm::dvec3 eye;
    glm::dvec3 forward;
    glm::dvec3 right;
    glm::dvec3 up;
};

CameraFrame camera_frame(const Camera& camera);

/// The rectangle of the plane at `target_height` through which parallel rays fill the picture; the unit square unless a
/// base surface reaches beyond it (scene/surface).
struct ParallelWindow {
    glm::dvec2 low{-0.5, -0.5};
    glm::dvec2 high{0.5, 0.5};
    /// The height in z from which rays start, and how far below it all that they can meet lies.
    double top = 0;
    double depth = 1;
};

/// The rays of a picture's pixels; row 0 is the top.
class PixelRays {
public:
    PixelRays(const Camera& camera, Resolution resolution, const ParallelWindow& window = {});

    /// Through the centre of pixel (i, j); i and j may be fractions.
    Ray at(double i, double j) const;

    /// The inverse: i and j of the ray that meets the point, which may lie outside the picture. Empty for a point that
    /// is not before the eye.
    std::optional<glm::dvec2> project(glm::dvec3 point) const;

private:
    bool parallel_;
    Resolution resolution_;
    ParallelWindow window_;
    glm::dvec2 shift_;
    double target_height_;
    CameraFrame frame_;
    /// `right` and `up` times the tangents of the half angles that the picture spans.
    glm::dvec3 across_;
    glm::dvec3 upwards_;
};

/// Cosine of the angle between the middle and a corner of a perspective picture.
double cosine_of_picture_corner(const Camera& camera, Resolution resolution);

/// World to Vulkan clip space (y down, depth 0..1, less is nearer) with exactly the pixels of PixelRays. Perspective:
/// depth = 1 − near/(view depth), an infinite far plane, so that nothing is cut off however far a grazing ray travels.
glm::dmat4 perspective_clip(const Camera& camera, Resolution resolution, double near);

/// The same for parallel rays: an oblique affine projection that slides points along the rays onto the plane at
/// `target_height`, where the window fills the target; depth is then (top − z)/depth of the window.
glm::dmat4 parallel_clip(const Camera& camera, const ParallelWindow& window);

}  // namespace reliefbench
