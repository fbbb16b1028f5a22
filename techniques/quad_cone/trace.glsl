#include "texel_steps.glsl"

#ifdef RELIEFBENCH_BENT_RAY
float ratio_along(vec4 ratios, vec2 way) {
    vec2 pair = abs(way.x) >= abs(way.y) ? ratios.xy : ratios.zw;
    return (abs(way.x) >= abs(way.y) ? way.x : way.y) >= 0.0 ? pair.x : pair.y;
}

// The narrower of the cones about the axes of the texture that the ray mostly goes along here and at its end: what it
// covers from here on lies between the ways at both.
vec2 tap_cone(ReliefRay ray, float s) {
    vec2 uv = point_on_ray(ray, s);
    vec4 ratios = tap_map(cones, uv, 0.0);
    float narrower = min(ratio_along(ratios, way_of_ray(ray, s)), ratio_along(ratios, way_of_ray(ray, end_of_ray(ray))));
    return vec2(tap_height(uv), narrower);
}
#else
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
#endif

Trace trace(ReliefRay ray) { return trace_by_texels(ray); }
