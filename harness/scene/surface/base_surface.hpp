#pragma once

#include "scene/surface/plane.hpp"

#include <optional>
#include <variant>

namespace reliefbench {

/// What the relief lies on: every base surface there is. P(u, v) over (u, v) ∈ [0, 1]² with the unit normal N(u, v) on
/// the side that is seen; the relief is S = P + (h − 1)·H·N. Another one gets a file pair beside plane.hpp with the
/// functions below, and a place in this list; whoever counts on straight rays asks for flat_base, which does not
/// compile for others until it says what of them.
struct BaseSurface {
    std::variant<Plane> kind;

    bool operator==(const BaseSurface&) const = default;
};

/// The base as a plane: for tracers that count on straight rays.
Plane flat_base(const BaseSurface& base);

/// P + above·N.
glm::dvec3 base_point(const BaseSurface& base, glm::dvec2 uv, double above);

/// ∂P/∂u, ∂P/∂v and N.
TangentFrame tangent_frame(const BaseSurface& base, glm::dvec2 uv);

/// The unit normal in world space of a relief whose offset along N changes with u and v by `slope`.
glm::dvec3 relief_normal(const BaseSurface& base, glm::dvec2 uv, glm::dvec2 slope);

/// Where the ray first meets the base from the side that is seen: empty outside the footprint F.
std::optional<BaseEntry> find_entry(const BaseSurface& base, const Ray& ray);

/// The ray of light through a point of the relief over `uv`, from where it passes the base; empty where the direction
/// to the light does not rise above the base. `to_light`: a unit vector.
std::optional<Ray> light_ray(const BaseSurface& base, glm::dvec2 uv, const glm::dvec3& point,
                             const glm::dvec3& to_light);

/// The same ray, which descends, from where it is higher over the base by `height`.
Ray started_above(const BaseSurface& base, const Ray& ray, double height);

/// A ray that meets what this one meets moved by so much in u, in v and along the normal.
Ray shifted(const BaseSurface& base, const Ray& ray, const glm::dvec3& by);

/// Perspective: a view depth that whatever can be seen of the relief exceeds. `cosine_of_corner`: of the angle between
/// the middle and a corner of the picture.
double nearest_depth(const BaseSurface& base, const Camera& camera, double cosine_of_corner);

/// Parallel rays: the part of z = 0 whose rays show the base.
ParallelWindow parallel_window(const BaseSurface& base, const Camera& camera, double height_scale);

/// Boundary::repeat: the unit square united with what rays of the footprint can reach within the relief.
PatchRegion visible_region(const BaseSurface& base, const Camera& camera, double height_scale);

}  // namespace reliefbench
