// Steps along cones that go at least a number of texels, for techniques with the parameters of cone_refinement.glsl,
// `max_steps`, `minimum_step` (in texels) and `step_rule` (added, larger).

#include "cone_refinement.glsl"

// Dummer 2006: w, which is one texel, is added to each step, measured along the ray in texture coordinates and with the
// relief one unit deep, whatever its height scale. So it is the shorter the less deep the relief is.
float added_step(ReliefRay ray) {
    if (step_rule != step_rule_added) return 0.0;
    vec2 size = vec2(height_map_size());
    return minimum_step / length(vec3(straight_offset(ray), 1.0) * vec3(size, max(size.x, size.y)));
}

float least_step(ReliefRay ray, float s) {
    return step_rule == step_rule_larger ? texels_along(ray, minimum_step) : 0.0;
}

#ifdef RELIEFBENCH_BENT_RAY
float end_of_cones(ReliefRay ray, float s) { return end_of_ray(ray); }
#endif

bool looks_for_bumps() { return false; }

// As Dummer's: what was added to the step that crossed the surface is taken back.
Trace trace_by_texels(ReliefRay ray) {
    ConeSearch search = search_cones(ray, max_steps, added_step(ray));
    if (refinement == refinement_none && search.converged) search.crossing.s_below = search.cone_end;
    return refine(ray, search);
}
