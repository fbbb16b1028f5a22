#ifndef RELIEFBENCH_PLANE_RAY_GLSL
#define RELIEFBENCH_PLANE_RAY_GLSL

// Rays over the plane, for the contract to which the technique is written.

#include "relief.glsl"
#include "scene.glsl"
#ifdef RELIEFBENCH_BENT_RAY
#include "bent_ray.glsl"
#include "hand_curvature.glsl"

// Only by a curvature that is given: the plane has none.
float bend_of(vec2 offset) {
    vec2 way = offset / scene.tiling;
    return dot(way, hand_fall() * way) / (2.0 * scene.height_scale);
}

vec2 uv_bend_of(vec2 offset) { return vec2(0.0); }
#endif

// `offset`: texture coordinates travelled from h = 1 to h = 0.
ReliefRay plane_ray(vec2 uv, vec2 offset, vec3 to_eye, vec2 uv_dx, vec2 uv_dy, float level) {
#ifdef RELIEFBENCH_CONTRACT_1
    return ReliefRay(uv, offset, to_eye, scene.tiling * scene.height_scale, uv_dx, uv_dy, level);
#elif defined(RELIEFBENCH_BENT_RAY)
    return ReliefRay(uv, to_eye, 1.0, scene.height_scale, mat2(scene.tiling), offset, uv_dx, uv_dy, level, 0.0, vec2(0.0));
#else
    return ReliefRay(uv, to_eye, 1.0, scene.height_scale, mat2(scene.tiling), offset, uv_dx, uv_dy, level);
#endif
}

#endif
