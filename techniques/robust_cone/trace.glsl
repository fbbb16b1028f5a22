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
    vec2 offset = straight_offset(ray);
    vec2 way = mix(in_cell, 1.0 - in_cell, greaterThan(offset, vec2(0.0)));
    vec2 walls = (way / size + beyond_wall) / max(abs(offset), vec2(slowest));
    return min(walls.x, walls.y);
}

bool looks_for_bumps() { return minimum_step && bump_check; }

Trace trace(ReliefRay ray) {
    return refine(ray, search_cones(ray, max_steps));
}
