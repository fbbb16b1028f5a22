#include "march.glsl"

// Linear search; at contact one step back, and that step is marched again with finer ones. The answer is the first
// of the finest layers at or beneath the surface.
Trace trace(ReliefRay ray) {
    int layers = layer_count(ray, min_steps, max_steps, adaptive);
    Crossing crossing = find_crossing(ray, layers);
    int finer_steps = refinement_steps > 0 ? refinement_steps : layers;
    float s_above = crossing.s_above;
    float s_below = crossing.s_below;
    int steps = crossing.steps;
    // A ray that enters at or beneath the surface has no step to march again.
    for (int level = 0; level < refinements && s_above < s_below; ++level) {
        float start = s_above;
        float end = s_below;
        // The last of the finer steps ends where contact is known already.
        for (int i = 1; i < finer_steps; ++i) {
            float s = mix(start, end, float(i) / float(finer_steps));
            steps += 1;
            if (tap_along(ray, s) >= 1.0 - s) {
                s_below = s;
                break;
            }
            s_above = s;
        }
    }
    return hit_on_ray(s_below, steps);
}
