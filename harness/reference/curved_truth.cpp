#include "reference/curved_truth.hpp"

#include "core/log.hpp"
#include "reference/curved_tracer.hpp"
#include "reference/diced_mesh.hpp"
#include "reference/filtered_truth.hpp"
#include "reference/pixel_loop.hpp"
#include "reference/sampled_relief.hpp"
#include "reference/surface_shader.hpp"
#include "reference/ties.hpp"
#include "scene/shading_normal.hpp"
#include "scene/surface/charts.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace reliefbench {

namespace {

/// What a truth's rays hit: the relief itself, or the facets of a mesh around it.
enum class HitBy { surface, facets };

/// A hit stands for the surface over its (u, v): a facet's own point lies beside it, often in its own shadow.
LitPoint lit_point(const Ray& ray, const CurvedHit& found, const BaseTriangle& triangle, HitBy hit_by,
                   const HeightMap& map, const Relief& relief) {
    const ExactHit& hit = found.hit;
    const glm::dvec3 normal = glm::normalize(triangle.linear_normal({hit.u, hit.v}));
    if (hit_by == HitBy::surface) return {.place = ray.origin + hit.t * ray.direction, .h = hit.h, .normal = normal};
    const double h = map.sample(relief.tiling * hit.u, relief.tiling * hit.v);
    return {.place = triangle.point({hit.u, hit.v}) + (h - 1) * relief.height_scale * normal, .h = h, .normal = normal};
}

/// A light's ray runs from beyond the whole relief towards the point, so that one part of a base shadows another.
bool light_reaches(const CurvedTracer& tracer, const Relief& relief, const LitPoint& point,
                   const glm::dvec3& to_light) {
    const double rise = glm::dot(point.normal, to_light);
    if (rise <= 0) return false;
    // How much higher than the point a hit must be to shadow it, as over the plane.
    const double tolerance = 2 * entry_tolerance * relief.height_scale / rise;
    const BoundingSphere& bounds = tracer.bounds();
    const double way = bounds.radius + glm::distance(bounds.centre, point.place);
    return !tracer.trace({point.place + way * to_light, -to_light}, way - tolerance).has_value();
}

class LightPathsOverMesh final : public LightPaths {
public:
    LightPathsOverMesh(const Image<std::optional<CurvedHit>>& hits, HitBy hit_by, const HeightMap& map,
                       const View& view, const CurvedTracer& tracer)
        : hits_(hits), hit_by_(hit_by), map_(map), relief_(view.relief), rays_(pixel_rays(view)), tracer_(tracer) {}

    LitPoint point(std::size_t pixel) const override {
        const auto width = static_cast<std::size_t>(hits_.size.width);
        const Ray ray = rays_.at(static_cast<double>(pixel % width), static_cast<double>(pixel / width));
        const CurvedHit& hit = *hits_.texels[pixel];
        return lit_point(ray, hit, base_triangle(curved_base(relief_.base), hit.triangle), hit_by_, map_, relief_);
    }

    void follow(std::span<const LightWay> ways, std::span<std::uint8_t> open) const override {
        std::ranges::transform(ways, open.begin(), [&](const LightWay& way) -> std::uint8_t {
            return light_reaches(tracer_, relief_, way.point, way.to_light) ? 1 : 0;
        });
    }

private:
    const Image<std::optional<CurvedHit>>& hits_;
    HitBy hit_by_;
    const HeightMap& map_;
    Relief relief_;
    PixelRays rays_;
    const CurvedTracer& tracer_;
};

/// Calls trace(ray) for hits; light is by the exact tracer.
template <typename Trace>
class SampledReliefOverMesh final : public SampledRelief {
public:
    SampledReliefOverMesh(const HeightMap& map, const View& view, const SurfaceShader& shader,
                          const CurvedTracer& tracer, HitBy hit_by, const Trace& trace)
        : map_(map),
          view_(view),
          mesh_(curved_base(view.relief.base)),
          shader_(shader),
          tracer_(tracer),
          hit_by_(hit_by),
          trace_(trace) {}

    void see(std::span<const Ray> rays, std::span<SurfaceSample> samples) const override {
        const Relief& relief = view_.relief;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::optional<CurvedHit> found = trace_(rays[i]);
            samples[i].is_hit = found.has_value();
            if (!found) continue;
            const ExactHit& hit = found->hit;
            const BaseTriangle triangle = base_triangle(mesh_, found->triangle);
            samples[i].t = hit.t;
            samples[i].uv = {hit.u, hit.v};
            samples[i].normal =
                relief_normal(triangle, samples[i].uv, (hit.h - 1) * relief.height_scale, shader_.slope(samples[i].uv));
            samples[i].point = lit_point(rays[i], *found, triangle, hit_by_, map_, relief);
        }
    }

    void light(std::span<const LitPoint> points, std::span<const glm::dvec3> to_light,
               std::span<std::uint8_t> reached) const override {
        for (std::size_t i = 0; i < points.size(); ++i)
            reached[i] = light_reaches(tracer_, view_.relief, points[i], to_light[i]) ? 1 : 0;
    }

private:
    const HeightMap& map_;
    const View& view_;
    const BaseMesh& mesh_;
    const SurfaceShader& shader_;
    const CurvedTracer& tracer_;
    HitBy hit_by_;
    const Trace& trace_;
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

    /// Calls trace(ray) for the samples of a picture of several.
    template <typename Trace>
    Truth finish(const Albedo& albedo, const Lighting& lighting, const TruthPicture& picture, HitBy hit_by,
                 const Trace& trace) {
        const LightPathsOverMesh paths(hits_, hit_by, map_, view_, tracer_);
        truth_.light_visibility = trace_light_visibility(truth_.hits, paths, view_, lighting);
        truth_.background = {static_cast<float>(lighting.background.r), static_cast<float>(lighting.background.g),
                             static_cast<float>(lighting.background.b)};
        if (picture.samples > 1) {
            const SurfaceShader shader(map_, albedo, view_.relief, lighting);
            filter_picture(truth_, SampledReliefOverMesh(map_, view_, shader, tracer_, hit_by, trace), shader, view_,
                           lighting, picture);
        } else {
            truth_.colour = shade_hits(truth_.hits, truth_.light_visibility.fractions, truth_.curved->normals, albedo,
                                       view_, lighting);
        }
        if (picture.object != nullptr) show_object(truth_, *picture.object, view_, lighting);
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

Truth trace_curved_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                         const TruthPicture& picture) {
    const auto start = std::chrono::steady_clock::now();
    CurvedTruthTracer tracing(map, view);
    const auto trace = [&](const Ray& ray) { return tracing.tracer().trace(ray); };
    tracing.find_hits(trace, [](const Ray&, const std::optional<CurvedHit>& hit) { return hit; });
    Truth truth = tracing.finish(albedo, lighting, picture, HitBy::surface, trace);
    truth.trace_ms = milliseconds_since(start);
    return truth;
}

Truth trace_diced_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                        int subdivision, const TruthPicture& picture) {
    const auto start = std::chrono::steady_clock::now();
    const DicedMesh mesh(map, view.relief, subdivision);
    CurvedTruthTracer tracing(map, view);
    const auto trace = [&](const Ray& ray) { return mesh.trace(ray); };
    tracing.find_hits(trace,
                      [&](const Ray& ray, const std::optional<CurvedHit>&) { return tracing.tracer().trace(ray); });
    Truth truth = tracing.finish(albedo, lighting, picture, HitBy::facets, trace);
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
