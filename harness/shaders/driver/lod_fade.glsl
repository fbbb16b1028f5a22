#ifndef RELIEFBENCH_LOD_FADE_GLSL
#define RELIEFBENCH_LOD_FADE_GLSL

// Level of detail of per-pixel techniques: relief that fades to normal mapping, after Tatarchuk's sample in the DirectX
// SDK (threshold: mip level 3; faded over the level below it).

#include "checked_trace.glsl"
#include "relief.glsl"
#include "scene.glsl"

// 0: all of the relief; 1: none of it. `distance` is the eye's from the ray's entry.
float lod_fade_at(ReliefRay ray, float distance) {
#if defined(LOD_FADE_TEXELS)
    // PlayCanvas: of a relief that no texel tells from a flat one nothing is to be seen but noise.
    float texels = length(straight_offset(ray) * vec2(height_map_size())) / exp2(max(0.0, ray.level));
    if (texels <= lod_fade_end_texels) return 1.0;
    return clamp((lod_fade_begin_texels - texels) / max(lod_fade_begin_texels - lod_fade_end_texels, 1e-6), 0.0, 1.0);
#elif defined(LOD_FADE_MIP) || defined(LOD_FADE_DISTANCE)
#ifdef LOD_FADE_MIP
    float level = ray.level;
#else
    float level = distance;
#endif
    if (level >= lod_fade_end) return 1.0;
    return clamp(1.0 - (lod_fade_end - level) / lod_fade_width, 0.0, 1.0);
#else
    return 0.0;
#endif
}

// The ray's parameter before the fade drew it to `s`.
float unfaded(float s, float fade) {
#ifdef RELIEFBENCH_POLYGON_HEIGHT
    return (s - fade * (1.0 - scene.polygon_height)) / (1.0 - fade);
#else
    return s / (1.0 - fade);
#endif
}

// The technique's answer, drawn towards the polygon along the ray. Where nothing is left of the relief it is not
// searched for.
Trace trace_faded(ReliefRay ray, float fade) {
#ifdef RELIEFBENCH_POLYGON_HEIGHT
    float s_polygon = 1.0 - scene.polygon_height;
    if (fade >= 1.0) return hit_on_ray(s_polygon, 0);
    Trace found = checked_trace(ray);
    found.s = mix(found.s, s_polygon, fade);
    found.uv = mix(found.uv, point_on_ray(ray, s_polygon), fade);
    found.h = mix(found.h, scene.polygon_height, fade);
#else
    if (fade >= 1.0) return hit_on_ray(0.0, 0);
    Trace found = checked_trace(ray);
    found.s *= 1.0 - fade;
    found.uv = mix(found.uv, ray.uv, fade);
    found.h = mix(found.h, 1.0, fade);
#endif
    return found;
}

#endif
