#include "reference/sampled_relief.hpp"

#include <glm/common.hpp>

#include <limits>
#include <utility>
#include <vector>

namespace reliefbench {

SampledReliefOverPlane::SampledReliefOverPlane(const HeightMap& map, const View& view, const SurfaceShader& shader,
                                               const ExactTracer& tracer, Trace trace)
    : map_(map), view_(view), shader_(shader), tracer_(tracer), trace_(std::move(trace)) {}

void SampledReliefOverPlane::see(std::span<const Ray> rays, std::span<SurfaceSample> samples) const {
    const Plane plane = flat_base(view_.relief.base);
    const bool is_shadowed = view_.self_shadow.mode != SelfShadow::Mode::off;
    std::vector<std::optional<ExactHit>> hits(rays.size());
    trace_(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        SurfaceSample& sample = samples[i];
        sample.is_hit =
            hits[i].has_value() && (view_.relief.boundary == Boundary::clip || is_in_footprint(rays[i], view_.relief));
        if (!sample.is_hit) continue;
        const ExactHit& hit = *hits[i];
        sample.t = hit.t;
        sample.uv = {hit.u, hit.v};
        sample.normal = relief_normal(plane, sample.uv, shader_.slope(sample.uv));
        if (!is_shadowed) continue;
        // A hit stands for the surface over its (u, v), whatever its h (trace_light_visibility).
        sample.point.h = map_.sample(view_.relief.tiling * hit.u, view_.relief.tiling * hit.v);
        sample.point.place = surface_point(view_.relief, hit.u, hit.v, sample.point.h);
    }
}

void SampledReliefOverPlane::light(std::span<const LitPoint> points, std::span<const glm::dvec3> to_light,
                                   std::span<std::uint8_t> reached) const {
    const Plane plane = flat_base(view_.relief.base);
    std::vector<Ray> rays;
    std::vector<std::size_t> owners;
    rays.reserve(points.size());
    owners.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        reached[i] = 0;
        const std::optional<Ray> ray = light_ray(plane, points[i].place, to_light[i]);
        if (!ray) continue;
        rays.push_back(*ray);
        owners.push_back(i);
    }
    std::vector<std::optional<ExactHit>> hits(rays.size());
    tracer_.trace(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::optional<ExactHit>& hit = hits[i];
        reached[owners[i]] = !hit || hit->h <= points[owners[i]].h + entry_tolerance ? 1 : 0;
    }
}

bool SampledReliefOverPlane::is_beyond(const std::array<Ray, 4>& corners) const {
    if (view_.relief.boundary == Boundary::repeat) return false;
    const Plane plane = flat_base(view_.relief.base);
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high = -low;
    for (const Ray& ray : corners) {
        if (!descends(plane, ray)) return false;
        const StraightPath path = straight_path(plane, ray, view_.relief.height_scale);
        for (const glm::dvec2& end : {path.uv, path.uv + path.uv_per_s}) {
            low = glm::min(low, end);
            high = glm::max(high, end);
        }
    }
    // Between the corners' rays all others cross both planes within their corners' hulls.
    constexpr double margin = 1e-9;
    return high.x < -margin || high.y < -margin || low.x > 1 + margin || low.y > 1 + margin;
}

}  // namespace reliefbench
