#include "slope_bounds.glsl"

// The derivatives of a bilinear cell lie between those of its sides.
void prepare(ivec2 cell) {
    vec4 rises = no_slopes;
    if (all(lessThan(cell, height_map_size()))) {
        vec4 corners = tap_height_cell(cell);
        vec2 along_u = corners.yw - corners.xz;
        vec2 along_v = corners.zw - corners.xy;
        rises = vec4(min(along_u.x, along_u.y), max(along_u.x, along_u.y), min(along_v.x, along_v.y),
                     max(along_v.x, along_v.y));
    }
    write_map(encode_slopes(rises));
}
