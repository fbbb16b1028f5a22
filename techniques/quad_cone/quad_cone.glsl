// Four conservative cones for each texel, each of the quarter of all directions about one axis of the texture.

#include "cone_search.glsl"

// Quarters in the order of the map's channels: along u onward and back, along v onward and back. A quarter is wider by a
// texel on both sides, for what is interpolated between texels within and without.
bvec4 quarters_of(vec2 way) {
    vec2 texel = 1.0 / vec2(height_map_size());
    bool along_u = abs(way.y) <= abs(way.x) + max(texel.x, texel.y);
    bool along_v = abs(way.x) <= abs(way.y) + max(texel.x, texel.y);
    return bvec4(along_u && way.x >= 0.0, along_u && way.x <= 0.0, along_v && way.y >= 0.0, along_v && way.y <= 0.0);
}

// The search of conservative_cone.glsl, within the reach of the widest of the four. The nearest repeat of a texel in one
// quarter may not be the nearest of all: the four repeats around are looked at.
vec4 search_quadrants(ivec2 texel) {
    vec4 narrowest = vec4(widest_cone * widest_cone);
    if (slice_begin() > 0) narrowest = folded_map() * folded_map();
    float apex = tap_height_texel(texel);
    for (NearFirst search = near_first(slice_begin()); search.number < slice_end();) {
        ivec2 offset;
        vec2 way;
        float widest = max(max(narrowest.x, narrowest.y), max(narrowest.z, narrowest.w));
        if (!take_within(square_reach_of(widest, apex), search, offset, way)) continue;
        float h = tap_height_texel(texel + offset);
        if (h <= apex) continue;
        vec2 onward = vec2(way.x > 0.0 ? -1.0 : 1.0, way.y > 0.0 ? -1.0 : 1.0);
        for (int repeat = 0; repeat < 4; ++repeat) {
            vec2 there = way + onward * vec2(repeat & 1, repeat >> 1);
            vec4 narrower = min(narrowest, vec4(square_ratio_to(dot(there, there), h, apex)));
            narrowest = mix(narrowest, narrower, quarters_of(there));
        }
    }
    return sqrt(narrowest);
}
