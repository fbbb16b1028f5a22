#include "march.glsl"
#include "refinement.glsl"

// Linear search; at contact one step back, and that step is marched again with finer ones.
Trace trace(ReliefRay ray) {
    int layers = layer_count(ray, min_steps, max_steps, adaptive);
    int finer_steps = refinement_steps > 0 ? refinement_steps : layers;
    Refined refined = refine_by_marching_again(ray, find_crossing(ray, layers), refinements, finer_steps);
    return hit_on_ray(refined.s, refined.steps);
}
