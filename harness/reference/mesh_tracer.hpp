#pragma once

#include "reference/exact_tracer.hpp"

#include <memory>

namespace reliefbench {

/// The surface displaced on the CPU and traced by Embree in robust mode: vertices at texel centres and
/// `subdivision` − 1 points between, one texel past each border (Boundary::clip; for Boundary::repeat as far as the
/// relief can be seen in the footprint by the given view), hits outside and back faces rejected. Converges to
/// ExactTracer as `subdivision` grows, and is what checks it.
class MeshTracer {
public:
    enum class Geometry { grid, triangles };

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
