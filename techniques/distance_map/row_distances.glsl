#include "metric.glsl"

// The distance from a voxel to the surface within one row of bilinear cells, each taken for a box as high as its highest
// corner, which contains it: the first half of an exact, separable distance transform.

float height_of_cell(ivec2 cell) {
    vec4 corners = tap_height_cell(cell);
    return max(max(corners.x, corners.y), max(corners.z, corners.w));
}

// Row `texel.y` lies between the texel centres texel.y and texel.y + 1.
void prepare(ivec3 texel) {
    int texels = height_map_size().x;
    float texel_width = 1.0 / float(texels);
    float h = slice_height(texel.z);
    float nearest = metric_height * h;
    for (int distance_in_texels = 0; distance_in_texels < search_reach(nearest, texel_width, texels); ++distance_in_texels) {
        float across = float(distance_in_texels) * texel_width;
        float highest = max(height_of_cell(texel.xy + ivec2(distance_in_texels, 0)),
                            height_of_cell(texel.xy - ivec2(distance_in_texels + 1, 0)));
        nearest = min(nearest, length(vec2(across, metric_height * max(h - highest, 0.0))));
    }
    write_map(vec4(round_down(nearest / metric_height)));
}
