#pragma once

#include "reference/relief_pieces.hpp"
#include "scene/height_map.hpp"

#include <glm/vec2.hpp>

#include <optional>

namespace reliefbench {

/// Where a ray passes from above the sheet to below it.
struct WalkHit {
    double t = 0;
    /// Of the relief's space (PrismPoint).
    glm::dvec3 point{};
};

/// What a walk could not decide.
struct WalkCounts {
    /// Spans along which the ray's way was not found, or not closely enough.
    std::size_t unresolved = 0;
};

/// A ray's way through one piece of a relief, in double precision: a cubic in (X, Y, Z) by t that is within 1e-9 of the
/// exact inverse (checked in the middle, halved where it is not), walked from block to block down the maxima of the
/// map; a crossing is bracketed on the cubic and found on the exact inverse.
class ReliefWalk {
public:
    ReliefWalk(const HeightMap& map, const MaximumMipChain& maxima, int level)
        : map_(&map), maxima_(&maxima), level_(level) {}

    /// The first crossing in the piece from `from` to `to` along the ray.
    std::optional<WalkHit> first_hit(const Prism& prism, const Prism::RayTerms& terms, const ReliefPiece& piece,
                                     const Ray& ray, double from, double to, WalkCounts& counts) const;

private:
    const HeightMap* map_;
    const MaximumMipChain* maxima_;
    int level_;
};

}  // namespace reliefbench
