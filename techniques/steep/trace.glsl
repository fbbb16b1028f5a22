#include "march.glsl"

// The first layer at or beneath the surface is the answer: never in front of the surface, up to one layer too deep.
Trace trace(ReliefRay ray) {
    Crossing crossing = find_crossing(ray, layer_count(ray, min_steps, max_steps, adaptive));
    return hit_on_ray(crossing.s_below, crossing.steps);
}
