#include "reference/curved_truth.hpp"

#include "core/log.hpp"
#include "reference/curved_tracer.hpp"
#include "reference/diced_mesh.hpp"
#include "reference/pixel_loop.hpp"
#include "reference/ties.hpp"
#include "scene/shading_normal.hpp"
#include "scene/surface/charts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbench {

namespace {

/// A light's ray runs from beyond the whole relief towards the point, so that one part of a base shadows another.
class LightPathsOverMesh final : public LightPaths {
public:
    LightPathsOverMesh(const Image<std::optional<CurvedHit>>& hits, const View& view, const CurvedTracer& tracer)
        : hits_(hits), relief_(view.relief), rays_(pixel_rays(view)), tracer_(tracer) {}

    LitPoint point(std::size_t pixel) const override {
        const auto width = static_cast<std::size_t>(hits_.size.width);
        const Ray ray = rays_.at(static_cast<double>(pixel % width), static_cast<double>(pixel / width));
        const CurvedHit& hit = *hits_.texels[pixel];
        const BaseTriangle triangle = base_triangle(curved_base(relief_.base), hit.triangle);
        return {.place = ray.origin + hit.hit.t * ray.direction,
                .h = hit.hit.h,
                .normal = glm::normalize(triangle.linear_normal({hit.hit.u, hit.hit.v}))};
    }

    bool reaches(const LitPoint& point, const glm::dvec3& to_light) const override {
        const double rise = glm::dot(point.normal, to_light);
        if (rise <= 0) return false;
        // How much higher than the point a hit must be to shadow it, as over the plane.
        const double tolerance = 2 * entry_tolerance * relief_.height_scale / rise;
        const BoundingSphere& bounds = tracer_.bounds();
        const double way = bounds.radius + glm::distance(bounds.centre, point.place);
        return !tracer_.trace({point.place + way * to_light, -to_light}, way - tolerance).has_value();
    }

private:
    const Image<std::optional<CurvedHit>>& hits_;
    Relief relief_;
    PixelRays rays_;
    const CurvedTracer& tracer_;
};

std::array<float, 3> shading_normal_over(const BaseTriangle& triangle, const Relief& relief,
                                         const Image<std::array<float, 2>>& derivatives, const glm::dvec3& hit) {
    const glm::dvec3 normal = relief_normal(triangle, {hit.x, hit.y}, (hit.z - 1) * relief.height_scale,
                                            shading_slope(derivatives, relief, hit.x, hit.y));
    return {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
}

class CurvedTruthTracer {
public:
    CurvedTruthTracer(const HeightMap& map, const View& view)
        : map_(map),
          view_(view),
          mesh_(curved_base(view.relief.base)),
          rays_(pixel_rays(view)),
          entries_(mesh_),
          tracer_(map, view.relief),
          hits_(view.resolution) {
        truth_.hits = HitImage(view.resolution);
        truth_.footprint = FootprintImage(view.resolution);
        truth_.curved = CurvedTruth{.normals = Image<std::array<float, 3>>(view.resolution),
                                    .entry_triangles = Image<std::uint32_t>(view.resolution, no_triangle),
                                    .off_chart = Image<std::uint8_t>(view.resolution)};
    }

    const CurvedTracer& tracer() const { return tracer_; }

    /// Calls trace(ray) for every pixel whose hit a truth has; the exact hit by trace_exact(ray, hit), for ties.
    template <typename Trace, typename TraceExact>
    void find_hits(const Trace& trace, const TraceExact& trace_exact) {
        const Image<std::array<float, 2>> derivatives = height_derivatives(map_);
        for_each_pixel(view_.resolution, [&](int i, int j) {
            const Ray ray = rays_.at(i, j);
            const std::optional<MeshEntry> entry = entries_.find(ray);
            if (entry) truth_.curved->entry_triangles.at(i, j) = entry->triangle;
            const std::optional<CurvedHit> hit = trace(ray);
            if (hit) record(*hit, derivatives, i, j);
            if (entry)
                truth_.footprint.at(i, j) =
                    is_tie(ray, *entry, trace_exact(ray, hit)) ? tie_in_footprint : in_footprint;
        });
    }

    Truth finish(const Albedo& albedo, const Lighting& lighting) {
        const LightPathsOverMesh paths(hits_, view_, tracer_);
        truth_.light_visibility = trace_light_visibility(truth_.hits, paths, view_, lighting);
        truth_.colour =
            shade_hits(truth_.hits, truth_.light_visibility.fractions, truth_.curved->normals, albedo, view_, lighting);
        truth_.background = {static_cast<float>(lighting.background.r), static_cast<float>(lighting.background.g),
                             static_cast<float>(lighting.background.b)};
        if (tracer_.folded_triangles() > 0) {
            log_warning(
                "a relief of height scale {} turns inside out over {} of the {} triangles of the base '{}': hits there "
                "may be wrong; lower the height scale",
                view_.relief.height_scale, tracer_.folded_triangles(), mesh_.triangles.size(), mesh_.name);
        }
        if (tracer_.unresolved() > 0) {
            log_warning("the truth of '{}' over the base '{}' could not follow rays to full precision in {} places",
                        map_.name, mesh_.name, tracer_.unresolved());
        }
        return std::move(truth_);
    }

private:
    void record(const CurvedHit& found, const Image<std::array<float, 2>>& derivatives, int i, int j) {
        const ExactHit& hit = found.hit;
        hits_.at(i, j) = found;
        truth_.hits.at(i, j) = {static_cast<float>(hit.u), static_cast<float>(hit.v), static_cast<float>(hit.h),
                                static_cast<float>(hit.t)};
        truth_.curved->normals.at(i, j) =
            shading_normal_over(base_triangle(mesh_, found.triangle), view_.relief, derivatives, {hit.u, hit.v, hit.h});
        const std::uint32_t entered = truth_.curved->entry_triangles.at(i, j);
        const bool other_chart = entered != no_triangle && mesh_.charts[entered] != mesh_.charts[found.triangle];
        truth_.curved->off_chart.at(i, j) = other_chart ? 1 : 0;
    }

    /// Of the surface itself, as over the plane: rays shifted along the entry's u and v.
    bool is_tie(const Ray& ray, const MeshEntry& entry, const std::optional<CurvedHit>& hit) const {
        const double columns = view_.relief.tiling * map_.width();
        const double rows = view_.relief.tiling * map_.height();
        const auto moves = [&](const glm::dvec3& shift) {
            const std::optional<CurvedHit> other = tracer_.trace({ray.origin + shift, ray.direction});
            if (!hit || !other) return hit.has_value() != other.has_value();
            // On the border of its chart: a technique that stays on it has an answer of the one ray and not of the
            // other.
            if (mesh_.charts[hit->triangle] != mesh_.charts[other->triangle]) return true;
            const glm::dvec2 way = shortest_way({hit->hit.u - other->hit.u, hit->hit.v - other->hit.v},
                                                chart_period(mesh_, hit->triangle));
            return std::hypot(way.x * columns, way.y * rows) > tie_jump_texels;
        };
        const glm::dvec3 along_u = entry.entry.frame.along_u * (tie_shift_texels / columns);
        const glm::dvec3 along_v = entry.entry.frame.along_v * (tie_shift_texels / rows);
        return moves(along_u) || moves(-along_u) || moves(along_v) || moves(-along_v);
    }

    const HeightMap& map_;
    const View& view_;
    const BaseMesh& mesh_;
    PixelRays rays_;
    BaseEntries entries_;
    CurvedTracer tracer_;
    Image<std::optional<CurvedHit>> hits_;
    Truth truth_;
};

}  // namespace

Truth trace_curved_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting) {
    const auto start = std::chrono::steady_clock::now();
    CurvedTruthTracer tracing(map, view);
    tracing.find_hits([&](const Ray& ray) { return tracing.tracer().trace(ray); },
                      [](const Ray&, const std::optional<CurvedHit>& hit) { return hit; });
    Truth truth = tracing.finish(albedo, lighting);
    truth.trace_ms = milliseconds_since(start);
    return truth;
}

Truth trace_diced_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                        int subdivision) {
    const auto start = std::chrono::steady_clock::now();
    const DicedMesh mesh(map, view.relief, subdivision);
    CurvedTruthTracer tracing(map, view);
    tracing.find_hits([&](const Ray& ray) { return mesh.trace(ray); },
                      [&](const Ray& ray, const std::optional<CurvedHit>&) { return tracing.tracer().trace(ray); });
    Truth truth = tracing.finish(albedo, lighting);
    truth.trace_ms = milliseconds_since(start);
    return truth;
}

Image<std::array<float, 3>> normals_over(const HitImage& hits, const Image<std::uint32_t>& triangles,
                                         const HeightMap& map, const Relief& relief) {
    const BaseMesh& mesh = curved_base(relief.base);
    const Image<std::array<float, 2>> derivatives = height_derivatives(map);
    Image<std::array<float, 3>> normals(hits.size);
    for_each_pixel(hits.size, [&](int i, int j) {
        const Hit& hit = hits.at(i, j);
        const std::uint32_t triangle = triangles.at(i, j);
        if (!hit.is_hit() || triangle == no_triangle) return;
        normals.at(i, j) =
            shading_normal_over(base_triangle(mesh, triangle), relief, derivatives, {hit.u, hit.v, hit.h});
    });
    return normals;
}

}  // namespace reliefbench
