#include "reference/mesh_tracer.hpp"

#include "core/error.hpp"

#include <cassert>

namespace reliefbench {

struct MeshTracer::Scene {};

MeshTracer::MeshTracer(const HeightMap&, const View&, int, Geometry) {
    fail("this portable build has no Embree, which the mesh truth needs: use the exact truth, or a full build");
}

MeshTracer::~MeshTracer() = default;
MeshTracer::MeshTracer(MeshTracer&&) noexcept = default;
MeshTracer& MeshTracer::operator=(MeshTracer&&) noexcept = default;

std::optional<ExactHit> MeshTracer::trace(const Ray&) const {
    assert(false);
    return std::nullopt;
}

}  // namespace reliefbench
