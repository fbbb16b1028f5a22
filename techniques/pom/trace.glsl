#include "march.glsl"

// The surface between the two samples around the crossing is taken for a straight line (Luna 2012, section 4).
Trace trace(ReliefRay ray) {
    Crossing crossing = find_crossing(ray, layer_count(ray, min_steps, max_steps, adaptive));
    float above = (1.0 - crossing.s_above) - crossing.h_above;
    float below = crossing.h_below - (1.0 - crossing.s_below);
    // At the entry both samples are one.
    float fraction = crossing.steps == 0 ? 0.0 : above / (above + below);
    return hit_on_ray(mix(crossing.s_above, crossing.s_below, fraction), crossing.steps);
}
