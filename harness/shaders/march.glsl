// Linear search in uniform layers, shared by the marching techniques.

#include "crossing.glsl"

// Luna 2012, section 5: head-on rays take the minimum, grazing ones the maximum; fractions are cut off as published.
int layer_count(ReliefRay ray, int minimum, int maximum, bool by_view_angle) {
    if (!by_view_angle) return maximum;
    return max(1, int(mix(float(maximum), float(minimum), ray.to_eye.z)));
}

float tap_along(ReliefRay ray, float s) {
    return tap_height(point_on_ray(ray, s));
}

// Where the ray first passes beneath the surface, between two neighbouring layers. The last layer lies at h = 0, where
// every ray is at or beneath the surface: a crossing is always found.
Crossing find_crossing(ReliefRay ray, int layers) {
    float h = tap_along(ray, 0.0);
    Crossing crossing = Crossing(0.0, h, 0.0, h, 0);
    while (crossing.steps < layers && crossing.h_below < 1.0 - crossing.s_below) {
        crossing.steps += 1;
        crossing.s_above = crossing.s_below;
        crossing.h_above = crossing.h_below;
        crossing.s_below = float(crossing.steps) / float(layers);
        crossing.h_below = tap_along(ray, crossing.s_below);
    }
    return crossing;
}
