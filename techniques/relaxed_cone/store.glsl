#include "stored_cone.glsl"

void prepare(ivec2 texel) { write_map(stored_cone(tap_height_texel(texel), tap_map_texel(ratios, texel, 0).r)); }
