#include "cone_refinement.glsl"

vec2 tap_cone(ReliefRay ray, float s) { return tap_map(cones, point_on_ray(ray, s), 0.0).rg; }

float least_step(ReliefRay ray, float s) { return texels_along(ray, minimum_step); }

bool looks_for_bumps() { return false; }

Trace trace(ReliefRay ray) {
    return refine(ray, search_cones(ray, max_steps));
}
