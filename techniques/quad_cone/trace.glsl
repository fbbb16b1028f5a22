#include "texel_steps.glsl"

// The cone about the axis of the texture that the ray mostly goes along.
vec2 tap_cone(ReliefRay ray, float s) {
    vec2 uv = point_on_ray(ray, s);
    vec4 ratios = tap_map(cones, uv, 0.0);
    vec2 offset = straight_offset(ray);
    bool along_u = abs(offset.x) >= abs(offset.y);
    vec2 pair = along_u ? ratios.xy : ratios.zw;
    float way = along_u ? offset.x : offset.y;
    return vec2(tap_height(uv), way >= 0.0 ? pair.x : pair.y);
}

Trace trace(ReliefRay ray) { return trace_by_texels(ray); }
