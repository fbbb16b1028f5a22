// What techniques read at each step: (height, cone ratio) in 16 bits each. Heights of more bits are rounded up and ratios
// down, so that no cone reaches into the surface for it.

const float stored_steps = 65535.0;

vec4 stored_ratios(vec4 ratios) { return floor(ratios * stored_steps) / stored_steps; }

vec4 stored_cone(float h, float ratio) {
    float stored_h = round(h * stored_steps);
    if (stored_h / stored_steps < h) stored_h += 1.0;
    return vec4(stored_h / stored_steps, stored_ratios(vec4(ratio)).x, 0.0, 0.0);
}

// The narrowest ratio of the texel and its eight neighbours across repeats of the map: what is interpolated between the
// results holds at every place between (Ban, Valasek, Balint and Vad 2024).
float narrowest_around(sampler2D ratios, ivec2 texel) {
    ivec2 size = height_map_size();
    float narrowest = tap_map_texel(ratios, texel, 0).r;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            ivec2 neighbour = (texel + ivec2(x, y) + size) % size;
            narrowest = min(narrowest, tap_map_texel(ratios, neighbour, 0).r);
        }
    }
    return narrowest;
}
