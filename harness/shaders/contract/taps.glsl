#ifndef RELIEFBENCH_TAPS_GLSL
#define RELIEFBENCH_TAPS_GLSL

// The only way to read heights and derived maps. Every function is one fetch instruction and counts as one tap in
// probed compilations; in timed ones and in preparation passes nothing of the counting is left.

layout(set = 0, binding = 1) uniform sampler2D height_map;     // bilinear, repeating
layout(set = 0, binding = 2) uniform sampler2D height_texels;  // the same texels unfiltered, repeating

#ifdef RELIEFBENCH_PROBED
#include "work_counters.glsl"
#endif

void count_tap(uint texels) {
#ifdef RELIEFBENCH_PROBED
#if defined(RELIEFBENCH_CONTROL) || defined(RELIEFBENCH_EVALUATION)
    atomicAdd(work.stage_taps, 1u);
    atomicAdd(work.stage_texels, texels);
#else
    counted_taps += 1u;
    counted_texels += texels;
#endif
#endif
}

ivec2 height_map_size() { return textureSize(height_map, 0); }

// Bilinear height at texture coordinates.
float tap_height(vec2 uv) {
    count_tap(4u);
    return textureLod(height_map, uv, 0.0).r;
}

// One stored texel. Indices wrap: the sampler does it, which is cheaper than an integer division.
float tap_height_texel(ivec2 texel) {
    count_tap(1u);
    return textureLod(height_texels, (vec2(texel) + 0.5) / vec2(height_map_size()), 0.0).r;
}

// The corners (h00, h10, h01, h11) of the bilinear cell whose lower left texel centre is `cell`; indices wrap. The
// gather is taken where the four texels meet, half a texel from any of their centres.
vec4 tap_height_cell(ivec2 cell) {
    count_tap(4u);
    return textureGather(height_texels, vec2(cell + 1) / vec2(height_map_size()), 0).wzxy;
}

// Of a derived map. By its base alone: of textureSize with a level that differs from pixel to pixel lavapipe gives all of
// them the size of one pixel's level.
ivec2 map_size(sampler2D map, int level) { return max(textureSize(map, 0) >> level, ivec2(1)); }

bool between_levels(float lod) { return lod > 0.0 && fract(lod) > 0.0; }

// A derived map through its own filter, repeating.
vec4 tap_map(sampler2D map, vec2 uv, float lod) {
    count_tap(between_levels(lod) ? 8u : 4u);
    return textureLod(map, uv, lod);
}

// The same at the level that the sampler chooses for a pixel with these derivatives of its texture coordinates; counted as
// between two levels.
vec4 tap_map_gradients(sampler2D map, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
    count_tap(8u);
    return textureGrad(map, uv, uv_dx, uv_dy);
}

// A map of three dimensions: repeating along u and v, clamped along the height.
vec4 tap_map(sampler3D map, vec3 uvh, float lod) {
    count_tap(8u);
    return textureLod(map, uvh, lod);
}

// One stored texel of a derived map. No wrapping: the caller stays inside.
vec4 tap_map_texel(sampler2D map, ivec2 texel, int lod) {
    count_tap(1u);
    return texelFetch(map, texel, lod);
}

vec4 tap_map_texel(sampler3D map, ivec3 texel, int lod) {
    count_tap(1u);
    return texelFetch(map, texel, lod);
}

// As tap_height_cell of one channel, 0 to 3, of a derived map's base, whatever its filter.
vec4 tap_map_cell(sampler2D map, ivec2 cell, int channel) {
    count_tap(4u);
    vec2 place = vec2(cell + 1) / vec2(map_size(map, 0));
    switch (channel) {
        case 1:
            return textureGather(map, place, 1).wzxy;
        case 2:
            return textureGather(map, place, 2).wzxy;
        case 3:
            return textureGather(map, place, 3).wzxy;
    }
    return textureGather(map, place, 0).wzxy;
}

#endif
