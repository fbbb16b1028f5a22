#pragma once

#include "scene/surface/base_mesh.hpp"
#include "scene/surface/base_source.hpp"
#include "scene/surface/plane.hpp"

#include <memory>
#include <variant>

namespace reliefbench {

/// A base of triangles, shared by all views of it: two are equal where they share one mesh.
struct MeshBase {
    std::shared_ptr<const BaseMesh> mesh;

    bool operator==(const MeshBase&) const = default;
};

/// What the relief lies on: P(u, v) with the unit normal N(u, v) on the side that is seen; the relief is
/// S = P + (h − 1)·H·N. Whoever counts on straight rays over the unit square asks for flat_base, whoever knows
/// triangles for curved_base; what both kinds answer stands here.
struct BaseSurface {
    std::variant<Plane, MeshBase> kind;

    bool operator==(const BaseSurface&) const = default;
};

/// Generates the base, or reads it from its file. Throws Error for a file that cannot be read, and for a curvature that
/// the base cannot have.
BaseSurface load_base(const BaseSource& source);

bool is_flat(const BaseSurface& base);

/// The base as a plane; of one that is_flat.
Plane flat_base(const BaseSurface& base);

/// The base's triangles; of one that is not flat.
const BaseMesh& curved_base(const BaseSurface& base);

/// The same base as triangles: a plane's are the two halves of its unit square.
BaseSurface triangulated(const BaseSurface& base);

/// Perspective: a view depth that whatever can be seen of the relief exceeds, above 0. `cosine_of_corner`: of the angle
/// between the middle and a corner of the picture.
double nearest_depth(const BaseSurface& base, const Camera& camera, double height_scale, double cosine_of_corner);

/// Parallel rays: the part of z = 0 whose rays show the base and the floor h = 0 below it.
ParallelWindow parallel_window(const BaseSurface& base, const Camera& camera, double height_scale);

}  // namespace reliefbench
