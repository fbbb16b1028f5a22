#pragma once

#include "scene/camera.hpp"
#include "scene/ray.hpp"
#include "scene/surface/base_entry.hpp"

#include <cmath>
#include <optional>

namespace reliefbench {

/// The base surface that is flat: the unit square of z = 0, centred on the origin, P(u, v) = (u − ½, v − ½, 0), with
/// the normal z.
struct Plane {
    bool operator==(const Plane&) const = default;
};

/// P + above·N.
glm::dvec3 base_point(const Plane& plane, glm::dvec2 uv, double above);

/// ∂P/∂u, ∂P/∂v and N.
TangentFrame tangent_frame(const Plane& plane, glm::dvec2 uv);

/// The unit normal in world space of a relief whose offset along N changes with u and v by `slope`. Inline, as it is
/// called for each ray of a truth.
inline glm::dvec3 relief_normal(const Plane& /*plane*/, glm::dvec2 /*uv*/, glm::dvec2 slope) {
    return glm::normalize(glm::dvec3(-slope.x, -slope.y, 1.0));
}

/// Where the ray meets the unit square from above: empty outside the footprint F.
std::optional<BaseEntry> find_entry(const Plane& plane, const Ray& ray);

/// The ray of light through a point of the relief, from where it passes the plane; empty where the direction to the
/// light does not rise above it. `to_light`: a unit vector.
std::optional<Ray> light_ray(const Plane& plane, const glm::dvec3& point, const glm::dvec3& to_light);

/// The same ray, which descends, from where it is higher over the plane by `height`.
Ray started_above(const Plane& plane, const Ray& ray, double height);

/// A ray that meets what this one meets moved by so much in u, in v and along the normal.
Ray shifted(const Plane& plane, const Ray& ray, const glm::dvec3& by);

/// Perspective: a view depth that whatever can be seen of the relief exceeds. `cosine_of_corner`: of the angle between
/// the middle and a corner of the picture.
double nearest_depth(const Plane& plane, const Camera& camera, double cosine_of_corner);

/// Boundary::repeat: the unit square united with what rays of the footprint can reach within the relief.
PatchRegion visible_region(const Plane& plane, const Camera& camera, double height_scale);

/// A descending ray as the relief over a plane sees it: at the parameter s it is at the height h = 1 − s over the patch
/// coordinates uv + s·uv_per_s, at the distance t_top + s·t_per_s. Only a flat base leaves rays straight.
struct StraightPath {
    glm::dvec2 uv;
    glm::dvec2 uv_per_s;
    double t_top = 0;
    double t_per_s = 0;
};

inline bool descends(const Plane& /*plane*/, const Ray& ray) {
    return ray.direction.z < 0;
}

/// Of a ray that descends. Inline, as it is called for each ray of a truth.
inline StraightPath straight_path(const Plane& /*plane*/, const Ray& ray, double height_scale) {
    const double t_per_z = 1 / ray.direction.z;
    const double t_top = -ray.origin.z * t_per_z;
    const double t_per_s = -height_scale * t_per_z;
    return StraightPath{
        .uv = {ray.origin.x + t_top * ray.direction.x + 0.5, ray.origin.y + t_top * ray.direction.y + 0.5},
        .uv_per_s = {t_per_s * ray.direction.x, t_per_s * ray.direction.y},
        .t_top = t_top,
        .t_per_s = t_per_s};
}

/// The way to where the ray's line crosses the plane, and that along which it rises by `height`; not for rays along the
/// plane.
inline double crossing_t(const Plane& /*plane*/, const Ray& ray) {
    return -ray.origin.z / ray.direction.z;
}
inline double rise_t(const Plane& /*plane*/, const Ray& ray, double height) {
    return height / ray.direction.z;
}

/// (u, v, z) of a point of the world: the patch coordinates below or above which it lies, and how far.
inline glm::dvec3 base_coordinates(const Plane& /*plane*/, const glm::dvec3& point) {
    return {point.x + 0.5, point.y + 0.5, point.z};
}

/// Whether a point lies neither over nor under the unit square.
inline bool is_beside(const Plane& /*plane*/, const glm::dvec3& point) {
    return std::abs(point.x) > 0.5 || std::abs(point.y) > 0.5;
}

}  // namespace reliefbench
