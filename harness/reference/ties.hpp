#pragma once

#include "reference/exact_tracer.hpp"

#include <optional>
#include <span>
#include <vector>

namespace reliefbench {

/// How far a ray is shifted to see whether its answer rests on rounding: beyond what single precision leaves of texture
/// coordinates, far below anything that a picture could show.
constexpr double tie_shift_texels = 1e-4;

/// A hit that moves by more than this under that shift is another hit.
constexpr double tie_jump_texels = 0.5;

/// Finds ties: rays that only touch the surface (a plateau's edge, a ridge along the ray, the border of a clipped
/// patch), so that they hit there or far behind it as rounding will have it. Neither answer is an error. Refers to the
/// map and the tracer, which must outlive it.
class TieFinder {
public:
    TieFinder(const HeightMap& map, const Relief& relief, const ExactTracer& tracer);

    /// Whether the ray, shifted by ±tie_shift_texels in u or in v, hits where it did not, or misses where it did, or
    /// hits more than tie_jump_texels from where it did. Costs as much as tracing two rays, and seven where it is
    /// close.
    bool is_tie(const Ray& ray) const;

    /// The same of each ray, in packets (ExactTracer::trace).
    std::vector<bool> find(std::span<const Ray> rays) const;

private:
    /// The ray's line lowered or raised by so much, in h.
    Ray lifted(const Ray& ray, double by) const;
    std::vector<std::optional<ExactHit>> trace(std::span<const Ray> rays) const;
    bool differ(const std::optional<ExactHit>& a, const std::optional<ExactHit>& b) const;
    bool is_near_border(const Ray& ray) const;

    const ExactTracer* tracer_;
    Plane plane_;
    double height_scale_;
    bool clip_;
    /// Texels of the map on a side of the patch.
    double columns_;
    double rows_;
    /// The surface rises by no more than this, in h, over the shift.
    double lift_;
};

}  // namespace reliefbench
