#include "conservative_cone.glsl"

void prepare(ivec2 texel) { write_map(vec4(search_all(texel))); }
