// Passes that fill a mip chain with maxima over bilinear cells: a map of 16 bits whose sides are powers of two.

const float stored_steps = 65535.0;

// Float heights are rounded up to what the map stores, so that a node's box always contains the surface.
float round_up(float h) {
    float stored = round(h * stored_steps);
    if (stored / stored_steps < h) stored += 1.0;
    return stored / stored_steps;
}

// Level 0: the highest point of a bilinear cell, which is one of its four corners.
float cell_maximum(ivec2 cell) {
    // Padding up to a power of two never blocks a ray.
    if (any(greaterThanEqual(cell, height_map_size()))) return 0.0;
    vec4 corners = tap_height_cell(cell);
    return max(max(corners.x, corners.y), max(corners.z, corners.w));
}

// Level 0 of a chain over texels in place of cells.
float texel_maximum(ivec2 texel) {
    return all(lessThan(texel, height_map_size())) ? tap_height_texel(texel) : 0.0;
}

#ifdef RELIEFBENCH_ABOVE_BASE
// Each further level: the highest of the four nodes beneath. Sides are powers of two, so nothing is left over.
float node_maximum(ivec2 node) {
    ivec2 child = 2 * node;
    float lower = max(previous_level(child).r, previous_level(child + ivec2(1, 0)).r);
    float upper = max(previous_level(child + ivec2(0, 1)).r, previous_level(child + ivec2(1, 1)).r);
    return max(lower, upper);
}
#endif
