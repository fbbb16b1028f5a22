#pragma once

#include "reference/base_entries.hpp"
#include "reference/exact_tracer.hpp"
#include "reference/maximum_mip_chain.hpp"
#include "reference/relief_pieces.hpp"
#include "reference/relief_walk.hpp"
#include "scene/height_map.hpp"
#include "scene/relief.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace reliefbench {

/// A hit on a base of triangles: (u, v) alone does not name a point of it.
struct CurvedHit {
    ExactHit hit;
    std::uint32_t triangle = 0;
};

/// Double-precision rays against the relief over a base of triangles: pieces of it (ReliefPieces) lie in a hierarchy of
/// boxes, and in each that a ray meets its way is walked (ReliefWalk). No subdivision parameter. Refers to map and
/// base, which must outlive it. Any number of threads may trace.
class CurvedTracer {
public:
    /// Throws Error in the portable build, and where there is not the memory. About `max_pieces` pieces where base and
    /// map do not need more.
    CurvedTracer(const HeightMap& map, const Relief& relief, double max_pieces = max_relief_pieces);

    /// The first point where the ray passes from above the sheet to below it; where it enters the relief from the
    /// front of the base over a height of 1 (to entry_tolerance), that is the entry. The sheet ends where the base's
    /// triangles end, whatever the boundary.
    /// Nothing from `before` on is looked for.
    std::optional<CurvedHit> trace(const Ray& ray, double before = std::numeric_limits<double>::infinity()) const;

    /// Around all that rays may meet.
    const BoundingSphere& bounds() const { return sphere_; }

    std::size_t pieces() const { return pieces_.pieces.size(); }
    /// Triangles over which the relief turns inside out: hits there may be wrong.
    std::size_t folded_triangles() const { return folded_; }
    /// Of all rays so far: pieces in which a ray's way or its crossing was not found to full precision.
    std::size_t unresolved() const { return *unresolved_; }

private:
    TexelScale scale_;
    MaximumMipChain maxima_;
    ReliefWalk walk_;
    BoundingSphere sphere_;
    std::vector<Prism> prisms_;
    ReliefPieces pieces_;
    std::size_t folded_ = 0;
    std::optional<BoxScene> boxes_;
    std::unique_ptr<std::atomic<std::size_t>> unresolved_;
};

}  // namespace reliefbench
