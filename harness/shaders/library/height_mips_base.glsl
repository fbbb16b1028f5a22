// The height map itself: level 0 of its mip chain.
void prepare(ivec2 texel) { write_map(vec4(tap_height_texel(texel))); }
