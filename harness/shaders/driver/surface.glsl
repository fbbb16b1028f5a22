#ifndef RELIEFBENCH_SURFACE_GLSL
#define RELIEFBENCH_SURFACE_GLSL

// The colour of a point found on the relief, and the outputs of fragment stages.

#include "scene.glsl"
#include "shading.glsl"
#include "srgb.glsl"
#include "taps.glsl"

#ifdef RELIEFBENCH_MATERIAL_MIPS
// With mip chains, through the filter that the cell asks for.
layout(set = 0, binding = 3) uniform sampler2D derivative_mips;
layout(set = 0, binding = 4) uniform sampler2D albedo_mips;

// Of this fragment, of the texture coordinates at which the material is read, to the pixels on its right and below it: the
// stage sets them before it asks for slopes or colours.
vec2 material_dx;
vec2 material_dy;
#else
layout(set = 0, binding = 3) uniform sampler2D height_derivatives;
layout(set = 0, binding = 4) uniform sampler2D albedo_map;
#endif

layout(location = 0) out vec4 colour_target;
#ifdef RELIEFBENCH_PROBED
layout(location = 1) out vec4 hit_target;
layout(location = 2) out vec4 shadow_target;
#ifdef RELIEFBENCH_CURVED
layout(location = 3) out vec4 normal_target;
#endif
#endif

#ifdef RELIEFBENCH_GRADIENTS_ANALYTIC
// How the relief's offset along N changes with texture coordinates, over a footprint of these gradients: a single texel's
// slope would be noise where pixels are larger than texels.
vec2 slope_over_footprint(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
    return scene.height_scale * textureGrad(derivative_mips, uv, uv_dx, uv_dy).rg;
}
#endif

#ifdef RELIEFBENCH_CURVED
// How the relief's offset along N changes with u and v.
vec2 surface_slope(vec2 patch_uv) {
#ifdef RELIEFBENCH_MATERIAL_MIPS
    return scene.height_scale * scene.tiling *
           textureGrad(derivative_mips, scene.tiling * patch_uv, material_dx, material_dy).rg;
#else
    return scene.height_scale * scene.tiling * textureLod(height_derivatives, scene.tiling * patch_uv, 0.0).rg;
#endif
}
#endif

// `hit` is (u, v, h, t) in patch coordinates; `visibility` that of each light. What has been tapped since count_pixel is
// the shadows' work.
#ifdef RELIEFBENCH_CURVED
// `normal`: in the world, a unit vector.
void write_surface(vec4 hit, vec3 direction, vec3 normal, vec3 visibility) {
#else
void write_surface(vec4 hit, vec3 direction, bool flat_normal, vec3 visibility) {
#endif
    vec2 uv = scene.tiling * hit.xy;
#ifdef RELIEFBENCH_MATERIAL_MIPS
    vec3 colour = textureGrad(albedo_mips, uv, material_dx, material_dy).rgb;
#else
    vec3 colour = textureLod(albedo_map, uv, 0.0).rgb;
#endif
    if (lighting_enabled) {
#ifndef RELIEFBENCH_CURVED
        vec3 normal = vec3(0.0, 0.0, 1.0);
#ifdef RELIEFBENCH_MATERIAL_MIPS
        if (!flat_normal) normal = shading_normal(textureGrad(derivative_mips, uv, material_dx, material_dy).rg);
#else
        if (!flat_normal) normal = shading_normal(textureLod(height_derivatives, uv, 0.0).rg);
#endif
#endif
        colour = shade(colour, normal, -direction, hit.w, visibility);
    }
    colour_target = vec4(srgb_target ? srgb_encode(colour) : colour, 1.0);
#ifdef RELIEFBENCH_PROBED
    hit_target = hit;
    shadow_target = vec4(visibility, float(counted_taps));
#ifdef RELIEFBENCH_CURVED
    normal_target = vec4(normal, 0.0);
#endif
#endif
}

#endif
