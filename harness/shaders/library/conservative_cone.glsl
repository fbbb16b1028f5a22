// Cones that no texel reaches into (Dummer 2006).

#include "cone_search.glsl"

// Over all texels for each texel: the cost grows with the fourth power of the map's side.
float search_all(ivec2 texel) {
    vec2 texel_size = 1.0 / vec2(height_map_size());
    float narrowest = folded_square_ratio();
    float apex = tap_height_texel(texel);
    for (NearFirst search = near_first(slice_begin()); search.number < slice_end(); search = next(search)) {
        ivec2 offset = offset_of(search);
        vec2 way = vec2(offset) * texel_size;
        narrowest = min(narrowest, square_ratio_to(dot(way, way), tap_height_texel(texel + offset), apex));
    }
    return sqrt(narrowest);
}

// The same ratios: near texels come first, and none that lies beyond the reach of the cone found so far is looked at.
float search_pruned(ivec2 texel) {
    float narrowest = folded_square_ratio();
    float apex = tap_height_texel(texel);
    for (NearFirst search = near_first(slice_begin()); search.number < slice_end();) {
        ivec2 offset;
        vec2 way;
        if (take_within(square_reach_of(narrowest, apex), search, offset, way))
            narrowest = min(narrowest, square_ratio_to(dot(way, way), tap_height_texel(texel + offset), apex));
    }
    return sqrt(narrowest);
}
