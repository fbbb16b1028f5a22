#pragma once

#include "reference/maximum_mip_chain.hpp"
#include "reference/window_maxima.hpp"
#include "scene/height_map.hpp"
#include "scene/relief.hpp"

#include <glm/vec3.hpp>

#include <optional>
#include <span>

namespace reliefbench {

/// A hit in double precision, coordinates as in `Hit`.
struct ExactHit {
    double u = 0;
    double v = 0;
    double h = 0;
    double t = 0;
};

/// Double-precision rays against the bilinear surface itself: hierarchical traversal over a maximum mip chain of the
/// bilinear cells (Tevs et al. 2008), the quadratic ray-patch equation in each cell. No subdivision parameter.
/// For a relief on the plane, over which rays are straight. Refers to the height map, which must outlive it. Immutable
/// after construction: any number of threads may trace.
class ExactTracer {
public:
    ExactTracer(const HeightMap& map, const Relief& relief);

    /// The first point where the ray passes from above the sheet to below it; where it enters the relief over a height
    /// of 1 (to entry_tolerance), that is the entry. Boundary::clip: the sheet is the unit square only, and a ray that
    /// enters the slab through its side beneath the sheet hits where it next does so. Boundary::repeat: the sheet goes
    /// on for ever. Rays that do not descend miss.
    std::optional<ExactHit> trace(const Ray& ray) const;

    /// The same of each ray, bit for bit; as many `hits` as `rays`. In packets, up to four times as fast, where rays are
    /// neighbours: every sixteen in a row lie close together (4 × 4 pixels, or samples of one), a multiple of 256 in
    /// all.
    void trace(std::span<const Ray> rays, std::span<std::optional<ExactHit>> hits) const;

private:
    const HeightMap* map_;
    Relief relief_;
    Plane plane_;
    MaximumMipChain maxima_;
    WindowMaxima windows_;
};

}  // namespace reliefbench
