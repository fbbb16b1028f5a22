// A fragment of real geometry: the hit is what the rasteriser interpolated.

#include "scene.glsl"
#include "surface.glsl"
#include "taps.glsl"
#include "work.glsl"

layout(location = 0) in vec3 surface;  // u, v, h
#ifdef RELIEFBENCH_CURVED
#include "base_mesh.glsl"

layout(location = 1) in vec3 surface_position;
layout(location = 2) flat in int surface_triangle;

// Of the displaced surface, dS/du x dS/dv.
vec3 normal_of_hit(vec2 patch_uv, float h) {
    BaseTriangle triangle = base_triangle(surface_triangle);
    vec3 linear = linear_normal(triangle, patch_uv);
    vec3 normal = normalize(linear);
    float above = (h - 1.0) * scene.height_scale / length(linear);
    vec2 slope = surface_slope(patch_uv);
    vec3 turn_u = triangle.normal_along_u - normal * dot(normal, triangle.normal_along_u);
    vec3 turn_v = triangle.normal_along_v - normal * dot(normal, triangle.normal_along_v);
    return normalize(triangle.handedness * cross(triangle.along_u + slope.x * normal + above * turn_u,
                                                 triangle.along_v + slope.y * normal + above * turn_v));
}

void main() {
    ViewRay view = view_ray(gl_FragCoord.xy);
    // Where textures repeat the base ends all the same, and what hangs over its border is part of it.
    count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
    float t = max(0.0, dot(surface_position - view.origin, view.direction));
    write_surface(vec4(surface, t), view.direction, normal_of_hit(surface.xy, surface.z), vec3(1.0));
}
#else

void main() {
    ViewRay view = view_ray(gl_FragCoord.xy);
    // Where the relief goes on for ever it is evaluated in the footprint of the patch only.
    if (relief_repeats && !inside_patch(view.entry)) discard;
    count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
    // As in quad.frag: never negative.
    float t = max(0.0, dot(surface_point(surface.xy, surface.z) - view.origin, view.direction));
    write_surface(vec4(surface, t), view.direction, false, vec3(1.0));
}
#endif
