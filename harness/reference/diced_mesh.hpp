#pragma once

#include "reference/curved_tracer.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace reliefbench {

/// The relief over a base of triangles, diced: every triangle split along the lines of texel centres and of
/// `subdivision` − 1 lines between, with flat facets between vertices of the relief, traced by Embree in robust mode.
/// Converges to CurvedTracer as `subdivision` grows, and is what checks it. Single precision: errors of some 1e-7 of
/// the base's size. Back faces are transparent. Refers to map and base, which must outlive it.
class DicedMesh {
public:
    /// Throws Error in the portable build, and where there would be too many facets.
    DicedMesh(const HeightMap& map, const Relief& relief, int subdivision);

    /// Where the ray enters the base over a height of 1 it has hit there, as with CurvedTracer.
    std::optional<CurvedHit> trace(const Ray& ray) const;

    std::size_t facets() const { return triangles_.size(); }

private:
    const HeightMap* map_;
    Relief relief_;
    TexelScale scale_;
    BoundingSphere sphere_;
    BaseEntries entries_;
    std::vector<Prism> prisms_;
    /// By facet, that of the base.
    std::vector<std::uint32_t> triangles_;
    std::optional<TriangleScene> facets_;
};

}  // namespace reliefbench
