#include "stored_cone.glsl"

void prepare(ivec2 texel) { write_map(stored_ratios(tap_map_texel(ratios, texel, 0))); }
