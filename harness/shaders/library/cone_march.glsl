#ifndef RELIEFBENCH_CONE_MARCH_GLSL
#define RELIEFBENCH_CONE_MARCH_GLSL

// Steps along cones, shared by the techniques that have some. A ray at a height `gap` above the surface, on the axis of a
// cone of this ratio, leaves the cone where it has come as far from the axis as the cone is wide there.

#include "bent_way.glsl"
#include "refinement.glsl"

float tap_along(ReliefRay ray, float s) { return tap_height(point_on_ray(ray, s)); }

// Height and cone ratio under the ray at s. Whoever includes this file defines how they are read, and how far each step
// goes at least, in s.
vec2 tap_cone(ReliefRay ray, float s);
float least_step(ReliefRay ray, float s);
#ifdef RELIEFBENCH_BENT_RAY
// How far cones lead from s: to the ray's end; relaxed ones, in which a ray that rises may come out of the surface again,
// not past its turn.
float end_of_cones(ReliefRay ray, float s);
#endif
// Whether a least step, which then ends within the bilinear cell that it begins in, looks for a bump on its way.
bool looks_for_bumps();

// Nearer above the surface than this is on it: half a step of a height map of 16 bits. Cones alone come ever closer and
// never there.
const float contact = 0.5 / 65535.0;

struct ConeSearch {
    // Where it holds none, because the search ended above the surface, both ends are the last point known to lie there.
    Crossing crossing;
    bool converged;
    // Where the last step left its cone, `added` short of where it went; the last point where that lies above the surface.
    float cone_end;
#ifdef RELIEFBENCH_BENT_RAY
    bool missed;  // the ray has left the relief at h = 1
#endif
};

// Whether the ray, with gaps above the surface at both ends of a way within one bilinear cell, can be beneath it in
// between: the surface rises above the straight line between its ends by at most half the product of the way's lengths
// along both axes of the texture, in texels.
bool may_pass_bump(ReliefRay ray, float s, float gap, float s_end, float gap_end) {
#ifdef RELIEFBENCH_BENT_RAY
    float reach = sqrt(gap) + sqrt(gap_end);
    // The ray's own sagging counts as well, and what its way bends along axes, along each of which the surface rises by 1
    // a texel at most.
    vec2 size = vec2(height_map_size());
    float s_way = s_end - s;
    vec2 bend = s_way * s_way * abs(ray.uv_bend) * size;
    vec2 way = s_way * abs(way_of_ray(ray, s)) * size + 2.0 * bend;
    return reach * reach < 2.0 * way.x * way.y + bend.x + bend.y + s_way * s_way * max(ray.bend, 0.0);
#else
    vec2 way = (s_end - s) * straight_offset(ray) * vec2(height_map_size());
    float reach = sqrt(gap) + sqrt(gap_end);
    return reach * reach < 2.0 * abs(way.x * way.y);
#endif
}

// Whether it is; then `s_lowest` is where it is deepest. Along the way the gap is a parabola, which one more point tells.
bool passes_bump(ReliefRay ray, float s, float gap, float s_end, float gap_end, out float s_lowest) {
    float middle = 0.5 * (s + s_end);
    float gap_middle = height_of_ray(ray, middle) - tap_along(ray, middle);
    // gap(t) = a t^2 + b t + gap, t from 0 to 1.
    float a = 2.0 * (gap + gap_end - 2.0 * gap_middle);
    float b = gap_end - gap - a;
    float t = a > 0.0 ? -b / (2.0 * a) : 0.0;
    s_lowest = mix(s, s_end, t);
    return t > 0.0 && t < 1.0 && gap + 0.5 * b * t < 0.0;
}

// Of the ray: height and cone ratio under it, and how far it lies above the surface.
struct ConePoint {
    float s;
    vec2 cone;
    float gap;
};

ConePoint tap_point(ReliefRay ray, float s) {
    vec2 cone = tap_cone(ray, s);
    return ConePoint(s, cone, height_of_ray(ray, s) - cone.x);
}

#ifdef RELIEFBENCH_BENT_RAY
// How far the ray stays within the cone of a point, in s: its way aside is |way| * s + |uv_bend| * s^2 at most, and the cone
// as wide as its ratio times the height of the ray above the apex, gap + slope * s + bend * s^2.
float way_in_cone(ReliefRay ray, ConePoint point) {
    float ratio = point.cone.y;
    float aside = length(way_of_ray(ray, point.s)) - ratio * slope_of_ray(ray, point.s);
    float stays = first_at(point.gap * ratio, aside, length(ray.uv_bend) - ratio * ray.bend);
    return min(stays, end_of_cones(ray, point.s) - point.s);
}
#endif

// Each step goes to the end of its cone, or the least step where that is longer, and `added` further, in s.
ConeSearch search_cones(ReliefRay ray, int most_steps, float added) {
    // Where the ray is at or beneath the surface, or has left the relief.
    float far_end = end_of_ray(ray);
#ifndef RELIEFBENCH_BENT_RAY
    float speed = length(straight_offset(ray));
#endif
    ConePoint start = tap_point(ray, 0.0);
    ConePoint end = start;
    float cone_end = 0.0;
    int steps = 0;
    while (true) {
        // A step that may have passed a bump is looked at outside of the steps' own loop, so that a processor that runs
        // pixels side by side does it for all of them at once.
        bool may_have_passed = false;
#ifdef RELIEFBENCH_BENT_RAY
        while (end.gap > contact && end.s < far_end && steps < most_steps && !may_have_passed)
#else
        while (end.gap > contact && steps < most_steps && !may_have_passed)
#endif
        {
            start = end;
            steps += 1;
#ifdef RELIEFBENCH_BENT_RAY
            float along_cone = way_in_cone(ray, start);
#else
            float along_cone = start.gap * start.cone.y / (start.cone.y + speed);
#endif
            float least = least_step(ray, start.s);
            cone_end = min(start.s + max(along_cone, least), far_end);
            end = tap_point(ray, min(cone_end + added, far_end));
            may_have_passed = looks_for_bumps() && least > along_cone && end.gap > 0.0 &&
                              may_pass_bump(ray, start.s, start.gap, end.s, end.gap);
        }
        if (!may_have_passed) break;
        float s_lowest;
        if (passes_bump(ray, start.s, start.gap, end.s, end.gap, s_lowest)) {
            end = tap_point(ray, s_lowest);
            cone_end = s_lowest;
        }
    }
    if (end.gap > 0.0) {
        start = end;
        cone_end = end.s;
    }
#ifdef RELIEFBENCH_BENT_RAY
    bool at_end = end.s >= far_end;
    bool missed = at_end && end.gap > contact && leaves_above(ray);
    return ConeSearch(Crossing(start.s, start.cone.x, end.s, end.cone.x, steps), end.gap <= contact || at_end, cone_end,
                      missed);
#else
    return ConeSearch(Crossing(start.s, start.cone.x, end.s, end.cone.x, steps), end.gap <= contact, cone_end);
#endif
}

ConeSearch search_cones(ReliefRay ray, int most_steps) { return search_cones(ray, most_steps, 0.0); }

// The ray parameter of a way of so many texels along the ray, up and down included; at the entry's speed if it bends.
float texels_along(ReliefRay ray, float texels) {
    vec2 size = vec2(height_map_size());
    return texels / length(vec3(straight_offset(ray), height_in_uv(ray)) * vec3(size, max(size.x, size.y)));
}

// The answer of a search that ended above the surface, or whose crossing is taken as it was found.
Refined unrefined(ConeSearch search) { return Refined(search.crossing.s_below, search.crossing.steps); }

bool holds_crossing(ConeSearch search) { return search.converged && search.crossing.s_above < search.crossing.s_below; }

Trace answer(ConeSearch search, Refined refined) {
#ifdef RELIEFBENCH_BENT_RAY
    if (search.missed) return miss(refined.steps);
#endif
    Trace found = hit_on_ray(refined.s, refined.steps);
    return search.converged ? found : unconverged(found);
}

#endif
