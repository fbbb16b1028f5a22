#include "march.glsl"

// Linear search, then a binary search in the layer found; the answer is the last point known to be beneath.
Trace trace(ReliefRay ray) {
    Crossing crossing = find_crossing(ray, layer_count(ray, min_steps, max_steps, adaptive));
    float s_above = crossing.s_above;
    float s_below = crossing.s_below;
    for (int i = 0; i < binary_steps; ++i) {
        float middle = 0.5 * (s_above + s_below);
        if (tap_along(ray, middle) < 1.0 - middle)
            s_above = middle;
        else
            s_below = middle;
    }
    return hit_on_ray(s_below, crossing.steps + binary_steps);
}
