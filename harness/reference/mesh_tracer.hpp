#pragma once

#include "reference/exact_tracer.hpp"

#include <memory>

namespace reliefbench {

/// The surface displaced on the CPU and traced by Embree in robust mode: vertices at texel centres and
/// `subdivision` − 1 points between, one texel past each border (Boundary::clip; for Boundary::repeat as far as the
/// relief can be seen in the footprint by the given view), hits outside and back faces rejected. For a relief on the
/// plane. Converges to ExactTracer as `subdivision` grows, and is what checks it. Embree counts in single precision:
/// rays are given to it from just above the relief on, which leaves errors of some 1e-7 patch sides; nothing refines
/// its hits. Where the ray enters the relief over a height of 1 it has hit there, as with ExactTracer. The portable
/// build has no Embree: there the constructor throws Error.
class MeshTracer {
public:
    enum class Geometry { grid, triangles };

    /// Every ray of the footprint may be traced, and with Boundary::clip any other too. Refers to the map, which must
    /// outlive it.
    MeshTracer(const HeightMap& map, const View& view, int subdivision, Geometry geometry = Geometry::grid);
    ~MeshTracer();
    MeshTracer(MeshTracer&&) noexcept;
    MeshTracer& operator=(MeshTracer&&) noexcept;

    std::optional<ExactHit> trace(const Ray& ray) const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace reliefbench
