// Cones in which a ray that comes from the axis above the apex pierces the surface at most once: it may enter the surface
// there, but not leave it again.

#include "cone_search.glsl"

// A texel at h = 1 meets the ray where it starts; what is nearer to it than this is seen under this slope.
const float steepest = 1e-6;

// GPU Gems 3, chapter 18 (Policarpo and Oliveira 2007): for each texel the ray from the cone's axis at h = 1 through the
// surface over that texel is followed beneath the surface, in `search_steps` steps down to h = 0, until it comes out; the
// cone ends there. Rays from lower on the axis, and what happens between two steps, are not looked at.
// The ratio along such a ray only grows. So it is followed only while it is below the narrowest so far, which changes no
// result and also ends the search at the reach of a conservative cone.
float search_published(ivec2 texel, int search_steps) {
    vec2 axis = (vec2(texel) + 0.5) / vec2(height_map_size());
    float narrowest = folded_square_ratio();
    float apex = tap_height_texel(texel);
    for (NearFirst search = near_first(slice_begin()); search.number < slice_end();) {
        ivec2 offset;
        vec2 way;
        if (!take_within(square_reach_of(narrowest, apex), search, offset, way)) continue;
        float square_distance = dot(way, way);
        float h = tap_height_texel(texel + offset);
        if (square_distance == 0.0 || square_ratio_to(square_distance, h, apex) >= narrowest) continue;

        // Of the way from the axis to the texel, for each unit of height; the ray meets h = 0 after the last step.
        vec2 slope = way / max(1.0 - h, steepest);
        for (int i = 1; i < search_steps; ++i) {
            float ray_h = h * (1.0 - float(i) / float(search_steps));
            vec2 ray_way = (1.0 - ray_h) * slope;
            float there = square_ratio_to(dot(ray_way, ray_way), ray_h, apex);
            if (there >= narrowest) break;
            if (tap_height(axis + ray_way) < ray_h) {
                narrowest = there;
                break;
            }
        }
    }
    return sqrt(narrowest);
}

// Whether the surface falls, along one of the edges between texels, on from here and away from a cone's axis that lies
// `way` before it. Edges across the way count on both sides: rays pass there, too.
bool falls_beyond(ivec2 texel, float h, vec2 way) {
    bool falls = false;
    if (way.x >= 0.0) falls = falls || tap_height_texel(texel + ivec2(1, 0)) < h;
    if (way.x <= 0.0) falls = falls || tap_height_texel(texel - ivec2(1, 0)) < h;
    if (way.y >= 0.0) falls = falls || tap_height_texel(texel + ivec2(0, 1)) < h;
    if (way.y <= 0.0) falls = falls || tap_height_texel(texel - ivec2(0, 1)) < h;
    return falls;
}

// Exact for rays over texels (after Ban, Valasek, Balint and Vad 2024): a ray leaves the surface only where it falls away
// from the axis, and a ray that is nearly level leaves it wherever it does. Where it falls, the ratio to it only grows on
// the way down; so the upper ends of its falling edges are all that narrows the cone.
float search_falling_edges(ivec2 texel) {
    float narrowest = folded_square_ratio();
    float apex = tap_height_texel(texel);
    for (NearFirst search = near_first(slice_begin()); search.number < slice_end();) {
        ivec2 offset;
        vec2 way;
        if (!take_within(square_reach_of(narrowest, apex), search, offset, way)) continue;
        float square_distance = dot(way, way);
        float h = tap_height_texel(texel + offset);
        float there = square_ratio_to(square_distance, h, apex);
        if (there < narrowest && falls_beyond(texel + offset, h, way)) narrowest = there;
    }
    return sqrt(narrowest);
}
