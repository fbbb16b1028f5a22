#ifndef RELIEFBENCH_PIXEL_STEP_GLSL
#define RELIEFBENCH_PIXEL_STEP_GLSL

// From pixel to pixel, over a base that is not flat.

#include "scene.glsl"

// How the point at distance t of the ray moves from pixel to pixel.
vec3 pixel_step_x(ViewRay view, float t) {
    if (scene.parallel_rays != 0) return vec3(scene.window_size.x / float(scene.resolution.x), 0.0, 0.0);
    return t * dot(view.direction, scene.forward) * (2.0 / float(scene.resolution.x)) * scene.right;
}
vec3 pixel_step_y(ViewRay view, float t) {
    if (scene.parallel_rays != 0) return vec3(0.0, -scene.window_size.y / float(scene.resolution.y), 0.0);
    return t * dot(view.direction, scene.forward) * (-2.0 / float(scene.resolution.y)) * scene.up;
}

#endif
