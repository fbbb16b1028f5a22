#include "march.glsl"
#include "refinement.glsl"

// Linear search, then the line through the surface's heights at the layer's ends.
Trace trace(ReliefRay ray) {
    Refined refined = refine_linearly(find_crossing(ray, layer_count(ray, min_steps, max_steps, adaptive)));
    return hit_on_ray(refined.s, refined.steps);
}
