#include "cone_refinement.glsl"

// How far beyond the wall of its cell the ray goes, in texture coordinates, so that rounding does not keep it there.
const float beyond_wall = 1e-5;

// A ray slower than this, in texture coordinates from h = 1 to h = 0, meets no wall.
const float slowest = 1e-12;

vec2 tap_cone(ReliefRay ray, float s) { return tap_map(cones, point_on_ray(ray, s), 0.0).rg; }

// To the nearest wall of the bilinear cell: within the cell a ray that comes from above crosses the surface once, but for
// bumps of less than a cell, which `bump_check` looks for.
float least_step(ReliefRay ray, float s) {
    if (!minimum_step) return 0.0;
    vec2 size = vec2(height_map_size());
    vec2 in_cell = fract(point_on_ray(ray, s) * size - 0.5);
#ifdef RELIEFBENCH_BENT_RAY
    vec2 below = in_cell / size + beyond_wall;
    vec2 above = (1.0 - in_cell) / size + beyond_wall;
    vec2 speed = way_of_ray(ray, s);
    bool is_above;
    return min(first_wall(below.x, above.x, speed.x, ray.uv_bend.x, is_above),
               first_wall(below.y, above.y, speed.y, ray.uv_bend.y, is_above));
#else
    vec2 offset = straight_offset(ray);
    vec2 way = mix(in_cell, 1.0 - in_cell, greaterThan(offset, vec2(0.0)));
    vec2 walls = (way / size + beyond_wall) / max(abs(offset), vec2(slowest));
    return min(walls.x, walls.y);
#endif
}

#ifdef RELIEFBENCH_BENT_RAY
// Past the turn least steps alone lead on where cones are relaxed.
float end_of_cones(ReliefRay ray, float s) {
    return preparation == preparation_falling_edges ? max(s, lowest_of_ray(ray)) : end_of_ray(ray);
}
#endif

bool looks_for_bumps() { return minimum_step && bump_check; }

Trace trace(ReliefRay ray) {
    return refine(ray, search_cones(ray, max_steps));
}
