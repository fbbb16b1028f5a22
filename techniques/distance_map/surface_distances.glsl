#include "metric.glsl"

// The distance from a voxel to the surface over all rows: the second half of the distance transform.

// Distances within the rows of cells above and below the texel centre; rows wrap.
float distance_in_row(ivec3 texel, int row) {
    int rows = height_map_size().y;
    return metric_height * tap_map_texel(row_distances, ivec3(texel.x, ((row % rows) + rows) % rows, texel.z), 0).r;
}

void prepare(ivec3 texel) {
    int rows = height_map_size().y;
    float texel_height = 1.0 / float(rows);
    float nearest = metric_height * slice_height(texel.z);
    for (int distance_in_rows = 0; distance_in_rows < search_reach(nearest, texel_height, rows); ++distance_in_rows) {
        float in_row = min(distance_in_row(texel, texel.y + distance_in_rows),
                           distance_in_row(texel, texel.y - distance_in_rows - 1));
        nearest = min(nearest, length(vec2(float(distance_in_rows) * texel_height, in_row)));
    }
    // What a point of the voxel can be nearer to the surface than the voxel's centre; read through a linear filter, whose
    // weights average as much, too.
    vec3 voxel = vec3(1.0 / vec2(height_map_size()), metric_height / float(slices));
    write_map(vec4(round_down((nearest - 0.5 * length(voxel)) / metric_height)));
}
