#include "march.glsl"
#include "refinement.glsl"

// Linear search for an interval that holds the crossing, then chords that bound it more and more tightly.
Trace trace(ReliefRay ray) {
    Crossing crossing = find_crossing(ray, layer_count(ray, min_steps, max_steps, adaptive));
    Refined refined = refine_by_secants(ray, crossing, secant_steps);
    return hit_on_ray(refined.s, refined.steps);
}
