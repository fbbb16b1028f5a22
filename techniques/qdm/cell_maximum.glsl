// Level 0: the highest point of each bilinear cell, which is one of its four corners.
const float stored_steps = 65535.0;

void prepare(ivec2 texel) {
    // Padding up to a power of two never blocks a ray.
    float highest = 0.0;
    if (all(lessThan(texel, height_map_size()))) {
        vec4 corners = tap_height_cell(texel);
        highest = max(max(corners.x, corners.y), max(corners.z, corners.w));
    }
    // Float heights are rounded up, so that the box always contains the surface.
    float stored = round(highest * stored_steps);
    if (stored / stored_steps < highest) stored += 1.0;
    write_map(vec4(stored / stored_steps));
}
