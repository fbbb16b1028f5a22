#include "march.glsl"

// By default the first layer at or beneath the surface is the answer: never in front of the surface, up to one layer too
// deep.
Trace trace(ReliefRay ray) {
    float layers = layer_count(ray);
    Crossing crossing = find_crossing(ray, layers);
#ifdef RELIEFBENCH_BENT_RAY
    if (has_missed(ray, crossing)) return miss(crossing.steps);
#endif
    Refined refined = refine(ray, crossing, layers);
    return hit_on_ray(refined.s, refined.steps);
}
