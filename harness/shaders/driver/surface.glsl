#ifndef RELIEFBENCH_SURFACE_GLSL
#define RELIEFBENCH_SURFACE_GLSL

// The colour of a point found on the relief, and the outputs of fragment stages.

#include "scene.glsl"
#include "shading.glsl"
#include "srgb.glsl"
#include "taps.glsl"

layout(set = 0, binding = 3) uniform sampler2D height_derivatives;
layout(set = 0, binding = 4) uniform sampler2D albedo_map;

layout(location = 0) out vec4 colour_target;
#ifdef RELIEFBENCH_PROBED
layout(location = 1) out vec4 hit_target;
layout(location = 2) out vec4 shadow_target;
#endif

// `hit` is (u, v, h, t) in patch coordinates; `visibility` that of each light. What has been tapped since count_pixel is
// the shadows' work.
void write_surface(vec4 hit, vec3 direction, bool flat_normal, vec3 visibility) {
    vec2 uv = scene.tiling * hit.xy;
    vec3 colour = textureLod(albedo_map, uv, 0.0).rgb;
    if (lighting_enabled) {
        vec3 normal = vec3(0.0, 0.0, 1.0);
        if (!flat_normal) normal = shading_normal(textureLod(height_derivatives, uv, 0.0).rg);
        colour = shade(colour, normal, -direction, hit.w, visibility);
    }
    colour_target = vec4(srgb_target ? srgb_encode(colour) : colour, 1.0);
#ifdef RELIEFBENCH_PROBED
    hit_target = hit;
    shadow_target = vec4(visibility, float(counted_taps));
#endif
}

#endif
