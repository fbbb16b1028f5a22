#include "march.glsl"

// Linear search for an interval that holds the crossing. Then ray and chord are intersected, and the intersection takes
// the place of the interval's end on its side of the surface, again and again: the interval always holds a crossing.
Trace trace(ReliefRay ray) {
    Crossing interval = find_crossing(ray, layer_count(ray, min_steps, max_steps, adaptive));
    float above = (1.0 - interval.s_above) - interval.h_above;
    float below = interval.h_below - (1.0 - interval.s_below);
    float s = interval.s_below;
    int steps = interval.steps;
    for (int i = 1; i <= secant_steps; ++i) {
        // Nothing is left to divide by where an end lies on the surface, the entry included.
        if (above <= 0.0 || below <= 0.0) break;
        s = mix(interval.s_above, interval.s_below, above / (above + below));
        steps += 1;
        // The last intersection is the answer; which side it lies on no longer matters.
        if (i == secant_steps) break;
        float gap = (1.0 - s) - tap_along(ray, s);
        if (gap > 0.0) {
            interval.s_above = s;
            above = gap;
        } else {
            interval.s_below = s;
            below = -gap;
        }
    }
    return hit_on_ray(s, steps);
}
