// Searches over all texels of the height map, for passes that are cut into slices of them. Each result is the narrowest
// ratio found so far.

#include "cone_preparation.glsl"

// The texels of the map as seen from one of them, across the nearest repeat and from near to far: rows from near to far,
// and the texels of each row likewise.
struct NearFirst {
    ivec2 place;  // how many columns and rows come before it
    int number;
    int width;
};

NearFirst near_first(int number) {
    int width = height_map_size().x;
    return NearFirst(ivec2(number % width, number / width), number, width);
}

// In texels: 0, 1, 2, 3, ... columns or rows become 0, 1, -1, 2, ...
ivec2 offset_of(NearFirst search) { return ((search.place + 1) >> 1) * (2 * (search.place & 1) - 1); }

NearFirst next_row(NearFirst search) {
    search.number += search.width - search.place.x;
    search.place = ivec2(0, search.place.y + 1);
    return search;
}

NearFirst next(NearFirst search) {
    search.place.x += 1;
    search.number += 1;
    if (search.place.x == search.width) search.place = ivec2(0, search.place.y + 1);
    return search;
}

// Past what is too far away: the rest of its row is farther still, and so is every later row where its own is.
NearFirst skip(NearFirst search, vec2 way, float square_reach) {
    search = next_row(search);
    if (way.y * way.y >= square_reach) search.number = slice_end();
    return search;
}

// Goes on by a texel, whose `offset` in texels and `way` in texture coordinates it tells; false where that lies beyond the
// reach, and the search went past all that does.
bool take_within(float square_reach, inout NearFirst search, out ivec2 offset, out vec2 way) {
    offset = offset_of(search);
    way = vec2(offset) * (1.0 / vec2(height_map_size()));
    bool within = dot(way, way) < square_reach;
    if (within)
        search = next(search);
    else
        search = skip(search, way, square_reach);
    return within;
}

// The narrowest ratio of the slices before, squared.
float folded_square_ratio() {
    if (slice_begin() == 0) return widest_cone * widest_cone;
    float ratio = folded_map().r;
    return ratio * ratio;
}
