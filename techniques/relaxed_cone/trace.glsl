#include "cone_march.glsl"

vec2 tap_cone(ReliefRay ray, float s) { return tap_map(cones, point_on_ray(ray, s), 0.0).rg; }

float least_step(ReliefRay ray, float s) { return 0.0; }

#ifdef RELIEFBENCH_BENT_RAY
// Past its turn there are no other cones to go by: a ray that comes out of the surface there goes unseen.
float end_of_cones(ReliefRay ray, float s) {
    float turn = lowest_of_ray(ray);
    return s < turn ? turn : end_of_ray(ray);
}
#endif

bool looks_for_bumps() { return false; }

// A fixed number of steps is the published method: the point that they reach is its answer, not one that a cap cut off.
// A cone that a ray pierces at most once leaves it above the surface or just past its first crossing, which halving finds.
Trace trace(ReliefRay ray) {
    ConeSearch search = search_cones(ray, max_steps);
#ifdef RELIEFBENCH_BENT_RAY
    if (search.missed) return miss(search.crossing.steps);
#endif
    Refined refined = unrefined(search);
    if (holds_crossing(search)) refined = refine_by_halving(ray, search.crossing, binary_steps);
    return hit_on_ray(refined.s, refined.steps);
}
