#ifndef RELIEFBENCH_BENT_WAY_GLSL
#define RELIEFBENCH_BENT_WAY_GLSL

// How far a search may go along a bent ray: what it moves along any axis is speed * s + bend * s^2.

#include "relief.glsl"

#ifdef RELIEFBENCH_BENT_RAY
// Later than the end of every ray.
const float never = 1e30;

// The first s > 0 at which speed * s + bend * s^2 comes to `distance`, at least 0, from below; `never` where it does not.
float first_at(float distance, float speed, float bend) {
    float discriminant = speed * speed + 4.0 * bend * distance;
    if (discriminant < 0.0) return never;
    float root = sqrt(discriminant);
    if (speed > 0.0) return 2.0 * distance / (speed + root);
    return bend > 0.0 ? (root - speed) / (2.0 * bend) : never;
}

// Where something between walls `below` and `above` it, at least 0 away, meets the first of them; whether that is the one
// above.
float first_wall(float below, float above, float speed, float bend, out bool is_above) {
    float at_above = first_at(above, speed, bend);
    float at_below = first_at(below, -speed, -bend);
    is_above = at_above <= at_below;
    return min(at_above, at_below);
}

// The ray's least height from s to s_end: at one of them, or where it turns.
float lowest_between(ReliefRay ray, float s, float s_end) {
    return height_of_ray(ray, clamp(lowest_of_ray(ray), s, s_end));
}
#endif

#endif
