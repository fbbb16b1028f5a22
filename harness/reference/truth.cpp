#include "reference/truth.hpp"

#include "reference/curved_truth.hpp"
#include "reference/exact_tracer.hpp"
#include "reference/filtered_truth.hpp"
#include "reference/mesh_tracer.hpp"
#include "reference/pixel_loop.hpp"
#include "reference/sampled_relief.hpp"
#include "reference/shading.hpp"
#include "reference/surface_shader.hpp"
#include "reference/ties.hpp"
#include "scene/shading_normal.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace reliefbench {
namespace {

Hit to_hit(const ExactHit& hit) {
    return {static_cast<float>(hit.u), static_cast<float>(hit.v), static_cast<float>(hit.h), static_cast<float>(hit.t)};
}

std::array<float, 3> to_float(const glm::dvec3& colour) {
    return {static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b)};
}

/// Visibility of the lights and picture of a truth that has its hits, which `trace` finds.
void light(Truth& truth, const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
           const TruthPicture& picture, const ExactTracer& tracer, const SampledReliefOverPlane::Trace& trace) {
    truth.light_visibility = trace_light_visibility(truth.hits, map, view, lighting);
    truth.background = to_float(lighting.background);
    if (picture.samples > 1) {
        const SurfaceShader shader(map, albedo, view.relief, lighting);
        filter_picture(truth, SampledReliefOverPlane(map, view, shader, tracer, trace), shader, view, lighting,
                       picture);
    } else {
        truth.colour = shade_hits(truth.hits, truth.light_visibility.fractions, map, albedo, view, lighting);
    }
    if (picture.object != nullptr) show_object(truth, *picture.object, view, lighting);
}

/// Calls trace(rays, hits) for all pixels whose hit a truth has, and marks F in the footprint.
template <typename Trace>
Truth trace_hits(const View& view, const Trace& trace) {
    Truth truth;
    truth.hits = HitImage(view.resolution);
    truth.footprint = FootprintImage(view.resolution);
    const PixelRays pixel_ray = pixel_rays(view);
    for_each_pixel_tile(view.resolution, [&](std::span<const PixelPlace> pixels) {
        std::vector<Ray> rays;
        std::vector<PixelPlace> places;
        rays.reserve(pixels.size());
        places.reserve(pixels.size());
        for (const PixelPlace& pixel : pixels) {
            const Ray ray = pixel_ray.at(pixel.column, pixel.row);
            const bool inside = is_in_footprint(ray, view.relief);
            truth.footprint.at(pixel.column, pixel.row) = inside ? in_footprint : 0;
            if (!inside && view.relief.boundary == Boundary::repeat) continue;
            rays.push_back(ray);
            places.push_back(pixel);
        }
        std::vector<std::optional<ExactHit>> hits(rays.size());
        trace(rays, hits);
        for (std::size_t index = 0; index < hits.size(); ++index) {
            if (hits[index]) truth.hits.at(places[index].column, places[index].row) = to_hit(*hits[index]);
        }
    });
    return truth;
}

/// Of the surface itself, whatever the truth was traced with: a mesh's facets have ties of their own, which no
/// technique shares.
void mark_ties(Truth& truth, const HeightMap& map, const View& view, const ExactTracer& tracer) {
    const TieFinder ties(map, view.relief, tracer);
    const PixelRays pixel_ray = pixel_rays(view);
    for_each_pixel_tile(view.resolution, [&](std::span<const PixelPlace> pixels) {
        std::vector<Ray> rays;
        std::vector<PixelPlace> places;
        for (const PixelPlace& pixel : pixels) {
            if (truth.footprint.at(pixel.column, pixel.row) == 0) continue;
            rays.push_back(pixel_ray.at(pixel.column, pixel.row));
            places.push_back(pixel);
        }
        const std::vector<bool> are_ties = ties.find(rays);
        for (std::size_t index = 0; index < places.size(); ++index) {
            if (are_ties[index]) truth.footprint.at(places[index].column, places[index].row) = tie_in_footprint;
        }
    });
}

/// Calls normal(i, j) for each pixel that has a hit.
template <typename Normal>
Image<std::array<float, 3>> shade_with(const HitImage& hits, const Image<std::array<float, 3>>& visibility,
                                       const Albedo& albedo, const View& view, const Lighting& lighting,
                                       const Normal& normal) {
    const double tiling = view.relief.tiling;
    const PixelRays rays = pixel_rays(view);
    Image<std::array<float, 3>> colour(hits.size);
    for_each_pixel(hits.size, [&](int i, int j) {
        const Hit& hit = hits.at(i, j);
        glm::dvec3 linear = lighting.background;
        if (hit.is_hit()) {
            const std::array<double, 3> sampled = albedo.sample(tiling * hit.u, tiling * hit.v);
            const glm::dvec3 to_eye = -rays.at(i, j).direction;
            const std::array<float, 3>& lit = visibility.at(i, j);
            linear = shade(lighting, {sampled[0], sampled[1], sampled[2]}, normal(i, j), to_eye, hit.t,
                           {lit[0], lit[1], lit[2]});
        }
        colour.at(i, j) = to_float(linear);
    });
    return colour;
}

}  // namespace

Truth trace_exact_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                        const TruthPicture& picture) {
    if (!is_flat(view.relief.base)) return trace_curved_truth(map, albedo, view, lighting, picture);
    const auto start = std::chrono::steady_clock::now();
    const ExactTracer tracer(map, view.relief);
    const auto trace = [&](std::span<const Ray> rays, std::span<std::optional<ExactHit>> hits) {
        tracer.trace(rays, hits);
    };
    Truth truth = trace_hits(view, trace);
    mark_ties(truth, map, view, tracer);
    light(truth, map, albedo, view, lighting, picture, tracer, trace);
    truth.trace_ms = milliseconds_since(start);
    return truth;
}

Truth trace_mesh_truth(const HeightMap& map, const Albedo& albedo, const View& view, const Lighting& lighting,
                       int subdivision, const TruthPicture& picture) {
    if (!is_flat(view.relief.base)) return trace_diced_truth(map, albedo, view, lighting, subdivision, picture);
    const auto start = std::chrono::steady_clock::now();
    const MeshTracer mesh(map, view, subdivision);
    const ExactTracer tracer(map, view.relief);
    const auto trace = [&](std::span<const Ray> rays, std::span<std::optional<ExactHit>> hits) {
        std::ranges::transform(rays, hits.begin(), [&](const Ray& ray) { return mesh.trace(ray); });
    };
    Truth truth = trace_hits(view, trace);
    mark_ties(truth, map, view, tracer);
    light(truth, map, albedo, view, lighting, picture, tracer, trace);
    truth.trace_ms = milliseconds_since(start);
    return truth;
}

void show_object(Truth& truth, const SceneObject& object, const View& view, const Lighting& lighting) {
    truth.front = Image<Front>(view.resolution, Front::nothing);
    const PixelRays rays = pixel_rays(view);
    for_each_pixel(view.resolution, [&](int i, int j) {
        const Ray ray = rays.at(i, j);
        const Hit& hit = truth.hits.at(i, j);
        Front& front = truth.front->at(i, j);
        front = hit.is_hit() ? Front::relief : Front::nothing;
        const std::optional<ObjectHit> met = intersect(object, ray, view.camera.projection);
        if (!met || (hit.is_hit() && met->t >= hit.t)) return;
        front = Front::object;
        // One of several samples has it already, each where its own ray meets it.
        if (truth.samples > 1) return;
        const glm::dvec3 linear = shade(lighting, object.colour, met->normal, -ray.direction, met->t);
        truth.colour.at(i, j) = to_float(linear);
    });
}

Image<std::array<float, 3>> shade_hits(const HitImage& hits, const Image<std::array<float, 3>>& visibility,
                                       const HeightMap& map, const Albedo& albedo, const View& view,
                                       const Lighting& lighting) {
    const Image<std::array<float, 2>> derivatives = height_derivatives(map);
    return shade_with(hits, visibility, albedo, view, lighting, [&](int i, int j) {
        const Hit& hit = hits.at(i, j);
        return shading_normal(derivatives, view.relief, hit.u, hit.v);
    });
}

Image<std::array<float, 3>> shade_hits(const HitImage& hits, const Image<std::array<float, 3>>& visibility,
                                       const Image<std::array<float, 3>>& normals, const Albedo& albedo,
                                       const View& view, const Lighting& lighting) {
    return shade_with(hits, visibility, albedo, view, lighting, [&](int i, int j) {
        const std::array<float, 3>& normal = normals.at(i, j);
        return glm::dvec3(normal[0], normal[1], normal[2]);
    });
}

Image<std::array<float, 3>> shade_hits(const HitImage& hits, const HeightMap& map, const Albedo& albedo,
                                       const View& view, const Lighting& lighting) {
    return shade_hits(hits, Image<std::array<float, 3>>(hits.size, {1, 1, 1}), map, albedo, view, lighting);
}

}  // namespace reliefbench
