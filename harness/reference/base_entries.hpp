#pragma once

#include "reference/embree_scene.hpp"
#include "scene/surface/base_mesh.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace reliefbench {

/// Where a ray enters the relief through a base of triangles.
struct MeshEntry {
    BaseEntry entry;
    /// In BaseMesh::triangles.
    std::uint32_t triangle = 0;
};

/// A sphere around all that rays may meet: what starts them close to it, as boxes are met in single precision.
struct BoundingSphere {
    glm::dvec3 centre{};
    double radius = 0;

    /// The way from the ray's start to before the sphere; 0 where it starts within.
    double way_to(const Ray& ray) const;
    /// What boxes have to be widened by, so that rays that start there do not miss one by rounding.
    double box_margin() const;
};

/// Around the base and the floor, `height_scale` below it.
BoundingSphere bounding_sphere(const BaseMesh& mesh, double height_scale);

/// Finds the first triangle that a ray meets from its front, in double precision: no ray passes between two triangles
/// that share both vertices of a side. Refers to the mesh, which must outlive it. Immutable after construction: any
/// number of threads may ask.
class BaseEntries {
public:
    /// Throws Error in the portable build.
    explicit BaseEntries(const BaseMesh& mesh);

    /// Triangles whose charts span no area are not met.
    std::optional<MeshEntry> find(const Ray& ray) const;

private:
    std::optional<double> front_t(const Ray& ray, std::uint32_t triangle) const;

    const BaseMesh* mesh_;
    BoundingSphere sphere_;
    std::optional<BoxScene> boxes_;
};

}  // namespace reliefbench
