#include "texel_steps.glsl"

vec2 tap_cone(ReliefRay ray, float s) {
    vec2 cone = tap_map(cones, point_on_ray(ray, s), 0.0).rg;
    return cone_encoding == cone_encoding_square_root ? vec2(cone.x, cone.y * cone.y) : cone;
}

Trace trace(ReliefRay ray) { return trace_by_texels(ray); }
