#include "stored_cone.glsl"

void prepare(ivec2 texel) { write_map(stored_cone(tap_height_texel(texel), narrowest_around(ratios, texel))); }
