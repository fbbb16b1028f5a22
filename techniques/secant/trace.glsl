#include "march.glsl"

// By default a linear search for an interval that holds the crossing, then chords that bound it more and more tightly.
Trace trace(ReliefRay ray) {
    float layers = layer_count(ray);
    Crossing crossing = find_crossing(ray, layers);
#ifdef RELIEFBENCH_BENT_RAY
    if (has_missed(ray, crossing)) return miss(crossing.steps);
#endif
    Refined refined = refine(ray, crossing, layers);
    return hit_on_ray(refined.s, refined.steps);
}
