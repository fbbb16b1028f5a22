#ifndef RELIEFBENCH_BENT_RAY_GLSL
#define RELIEFBENCH_BENT_RAY_GLSL

// What the driver fills into a bent ray (relief_ray.glsl), whatever says how the base is curved.

#include "relief.glsl"

// Of a way over the tangent plane from h = 1 to h = 0, in texture coordinates: how far the base has fallen away beneath its
// end, in units of H, and what it adds to the way that a relief is narrower below than on the base.
float bend_of(vec2 offset);
vec2 uv_bend_of(vec2 offset);

void bend_ray(inout ReliefRay ray, float bend, vec2 uv_bend) {
    ray.bend = bend;
    ray.uv_bend = uv_bend;
    ray.s_end = end_of_bend(bend);
}

// The ray of light through a point at height h over texture coordinates `uv`, from the straight one. A way r towards the
// light, it has the height h + r + bend*r^2; it enters the relief where that is 1. False where a hollow base keeps it below.
bool bend_light_ray(inout ReliefRay ray, vec2 uv, float h, out float s_point) {
    float depth = 1.0 - h;
    float bend = bend_of(ray.straight_offset);
    vec2 uv_bend = uv_bend_of(ray.straight_offset);
    float discriminant = 1.0 + 4.0 * bend * depth;
    if (discriminant <= 0.0) return false;
    float descent = sqrt(discriminant);  // for each unit of r, where it enters
    float way = 2.0 * depth / (1.0 + descent);
    vec2 offset = ray.straight_offset + depth * uv_bend;
    ray.uv = uv - way * (offset - way * uv_bend);
    ray.straight_offset = (offset - 2.0 * way * uv_bend) / descent;
    bend_ray(ray, bend / discriminant, uv_bend / discriminant);
    s_point = way * descent;
    return true;
}

#endif
