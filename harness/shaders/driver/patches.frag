// A fragment of real geometry: the hit is what the rasteriser interpolated.

#include "scene.glsl"
#include "surface.glsl"
#include "taps.glsl"
#include "work.glsl"

// With several samples for each pixel they are those of each.
#ifdef RELIEFBENCH_SAMPLES
#define at_sample sample
#else
#define at_sample
#endif

#ifdef RELIEFBENCH_OWN_PERSPECTIVE
layout(location = 0) noperspective sample in vec3 surface_over_w;
layout(location = 3) noperspective sample in float one_over_w;
#define surface (surface_over_w / one_over_w)
#else
layout(location = 0) at_sample in vec3 surface;  // u, v, h
#endif

#ifdef RELIEFBENCH_MATERIAL_MIPS
// Real geometry has gradients of its own, from before any neighbour is discarded.
void take_gradients() {
    material_dx = scene.tiling * dFdx(surface.xy);
    material_dy = scene.tiling * dFdy(surface.xy);
}
#endif

#ifdef RELIEFBENCH_CURVED
#include "base_mesh.glsl"

#ifdef RELIEFBENCH_OWN_PERSPECTIVE
layout(location = 1) noperspective sample in vec3 position_over_w;
#define surface_position (position_over_w / one_over_w)
#else
layout(location = 1) at_sample in vec3 surface_position;
#endif
layout(location = 2) flat in int surface_triangle;

void main() {
#ifdef RELIEFBENCH_MATERIAL_MIPS
    take_gradients();
#endif
    ViewRay view = view_ray(gl_FragCoord.xy);
    // Where textures repeat the base ends all the same, and what hangs over its border is part of it.
    count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
    float t = max(0.0, dot(surface_position - view.origin, view.direction));
    vec3 normal = displaced_normal(base_triangle(surface_triangle), surface.xy, surface.z, surface_slope(surface.xy));
    write_surface(vec4(surface, t), view.direction, normal, vec3(1.0));
}
#else

void main() {
#ifdef RELIEFBENCH_MATERIAL_MIPS
    take_gradients();
#endif
    ViewRay view = view_ray(gl_FragCoord.xy);
    // Where the relief goes on for ever it is evaluated in the footprint of the patch only.
    if (relief_repeats && !inside_patch(polygon_entry(view))) discard;
    count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
    // As in quad.frag: never negative.
    float t = max(0.0, dot(surface_point(surface.xy, surface.z) - view.origin, view.direction));
    write_surface(vec4(surface, t), view.direction, false, vec3(1.0));
}
#endif
