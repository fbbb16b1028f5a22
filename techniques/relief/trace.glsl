#include "march.glsl"
#include "refinement.glsl"

// Linear search, then a binary search in the layer found.
Trace trace(ReliefRay ray) {
    Crossing crossing = find_crossing(ray, layer_count(ray, min_steps, max_steps, adaptive));
    Refined refined = refine_by_halving(ray, crossing, binary_steps);
    return hit_on_ray(refined.s, refined.steps);
}
