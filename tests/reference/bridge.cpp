#include "reference/bridge.hpp"

#include "reference/curved_tracer.hpp"
#include "reference/exact_tracer.hpp"
#include "reference/truth.hpp"

namespace bridge {
namespace {

reliefbench::HeightMap make_map(const Map& map) {
    reliefbench::Image<float> heights({map.width, map.height});
    heights.texels.assign(map.heights, map.heights + heights.size.pixels());
    return reliefbench::make_height_map(heights, reliefbench::HeightFormat::r32f, "bridge");
}

reliefbench::Relief make_relief(const Map& map) {
    return {map.height_scale, map.tiling, map.repeat ? reliefbench::Boundary::repeat : reliefbench::Boundary::clip};
}

reliefbench::Camera make_camera(const View& view) {
    return {view.perspective ? reliefbench::Projection::perspective : reliefbench::Projection::parallel,
            view.view_angle, view.azimuth, view.distance, view.fov};
}

}  // namespace

bool trace_exact(const Map& map, const double origin[3], const double direction[3], double hit[4]) {
    const reliefbench::HeightMap heights = make_map(map);
    const reliefbench::ExactTracer tracer(heights, make_relief(map));
    const auto found = tracer.trace({{origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]}});
    if (!found) return false;
    hit[0] = found->u;
    hit[1] = found->v;
    hit[2] = found->h;
    hit[3] = found->t;
    return true;
}

void pixel_ray(const View& view, int i, int j, double origin[3], double direction[3]) {
    const reliefbench::Ray ray = reliefbench::PixelRays(make_camera(view), {view.width, view.height}).at(i, j);
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = ray.origin[axis];
        direction[axis] = ray.direction[axis];
    }
}

void truth_image(const Map& map, const View& view, int subdivision, float* hits) {
    const reliefbench::HeightMap heights = make_map(map);
    const reliefbench::View seen{make_camera(view), make_relief(map), {view.width, view.height}};
    const reliefbench::Albedo albedo = reliefbench::load_albedo({}, heights);
    const reliefbench::Truth truth = subdivision == 0
                                         ? reliefbench::trace_exact_truth(heights, albedo, seen, {})
                                         : reliefbench::trace_mesh_truth(heights, albedo, seen, {}, subdivision);
    for (const reliefbench::Hit& hit : truth.hits.texels) {
        *hits++ = hit.u;
        *hits++ = hit.v;
        *hits++ = hit.h;
        *hits++ = hit.t;
    }
}

void trace_curved(const Map& map, const Base& base, const double* rays, int count, double* hits) {
    const reliefbench::HeightMap heights = make_map(map);
    reliefbench::Relief relief = make_relief(map);
    using Kind = reliefbench::BaseSource::Kind;
    relief.base = reliefbench::load_base({.kind = base.kind == Base::Kind::cylinder ? Kind::cylinder
                                                  : base.kind == Base::Kind::sphere ? Kind::sphere
                                                                                    : Kind::saddle,
                                          .curvature = base.curvature,
                                          .segments = base.segments});
    const reliefbench::CurvedTracer tracer(heights, relief);
    for (int ray = 0; ray < count; ++ray, rays += 6, hits += 4) {
        hits[3] = -1;
        const auto found = tracer.trace({{rays[0], rays[1], rays[2]}, {rays[3], rays[4], rays[5]}});
        if (!found) continue;
        hits[0] = found->hit.u;
        hits[1] = found->hit.v;
        hits[2] = found->hit.h;
        hits[3] = found->hit.t;
    }
}

}  // namespace bridge
