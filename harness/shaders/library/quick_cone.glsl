// Conservative cones from a mip chain of maxima over texels, in a number of taps that grows with the logarithm of the
// map's side (after Valasek and Ban 2022). On every level `radius` nodes on each side are looked at; what finer levels
// have covered is left out, so that a node's distance is that of what it adds.

#include "cone_preparation.glsl"

// Texels along one axis, both ends included, counted on across repeats of the map.
struct Span {
    int low;
    int high;
};

// A node along one axis: side texels, unless the map's edge cuts it off.
struct Strip {
    Span span;
    int in_map;  // where it begins in the map
};

int wrap(int texel, int size) { return texel >= 0 ? texel % size : size - 1 - (-1 - texel) % size; }

// The node of 2^tree_level texels that holds `texel`.
Strip strip_around(int texel, int tree_level, int size) {
    int in_map = wrap(texel, size);
    int begin = in_map >> tree_level << tree_level;
    int low = texel - in_map + begin;
    return Strip(Span(low, low + min(1 << tree_level, size - begin) - 1), begin);
}

// The neighbour above; both begin where nodes of this level do.
Strip next_strip(Strip strip, int tree_level, int size) {
    int low = strip.span.high + 1;
    int in_map = strip.in_map + low - strip.span.low;
    if (in_map == size) in_map = 0;
    return Strip(Span(low, low + min(1 << tree_level, size - in_map) - 1), in_map);
}

// Rounded outwards to nodes.
Span outward(Span span, int tree_level, int size) {
    return Span(strip_around(span.low, tree_level, size).span.low, strip_around(span.high, tree_level, size).span.high);
}

// In texture coordinates from `texel` to the nearest of the span; 0 within it.
float way_to(Span span, int texel, int size) {
    return float(max(max(span.low - texel, texel - span.high), 0)) / float(size);
}

// To the nearest outside of it.
float way_out(Span span, int texel, int size) { return float(min(texel - span.low, span.high - texel) + 1) / float(size); }

bool contains(Span outer, Span inner) { return outer.low <= inner.low && inner.high <= outer.high; }

float quick_cone(sampler2D maxima, ivec2 texel, int radius) {
    ivec2 size = height_map_size();
    float apex = tap_height_texel(texel);
    float narrowest = widest_cone * widest_cone;
    Span covered_u = Span(texel.x, texel.x);
    Span covered_v = Span(texel.y, texel.y);
    int root = textureQueryLevels(maxima) - 1;
    for (int tree_level = 0; tree_level <= root; ++tree_level) {
        int reach = radius << tree_level;
        // To whole nodes of the next level, so that none of those is covered in part.
        Span span_u = outward(Span(texel.x - reach, texel.x + reach), tree_level + 1, size.x);
        Span span_v = outward(Span(texel.y - reach, texel.y + reach), tree_level + 1, size.y);
        Strip first_u = strip_around(span_u.low, tree_level, size.x);
        Strip v = strip_around(span_v.low, tree_level, size.y);
        for (; v.span.low <= span_v.high; v = next_strip(v, tree_level, size.y)) {
            float way_v = way_to(v.span, texel.y, size.y);
            bool row_covered = contains(covered_v, v.span);
            for (Strip u = first_u; u.span.low <= span_u.high; u = next_strip(u, tree_level, size.x)) {
                if (row_covered && contains(covered_u, u.span)) continue;
                vec2 way = vec2(way_to(u.span, texel.x, size.x), way_v);
                float square_distance = dot(way, way);
                if (square_distance >= square_reach_of(narrowest, apex)) continue;
                ivec2 node = ivec2(u.in_map, v.in_map) >> tree_level;
                float highest = tap_map_texel(maxima, node, tree_level).r;
                narrowest = min(narrowest, square_ratio_to(square_distance, highest, apex));
            }
        }
        covered_u = span_u;
        covered_v = span_v;
        // Farther repeats narrow no cone that the nearest do not, nor does what is beyond the cone's reach.
        vec2 nearest = vec2(way_out(covered_u, texel.x, size.x), way_out(covered_v, texel.y, size.y));
        float way = min(nearest.x, nearest.y);
        if (way >= 0.5 || way * way >= square_reach_of(narrowest, apex)) break;
    }
    return sqrt(narrowest);
}
