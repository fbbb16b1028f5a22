#include "march.glsl"

// By default a linear search; at contact one step back, and that step is marched again with finer ones.
Trace trace(ReliefRay ray) {
    float layers = layer_count(ray);
    Crossing crossing = find_crossing(ray, layers);
#ifdef RELIEFBENCH_BENT_RAY
    if (has_missed(ray, crossing)) return miss(crossing.steps);
#endif
    Refined refined = refine(ray, crossing, layers);
    return hit_on_ray(refined.s, refined.steps);
}
