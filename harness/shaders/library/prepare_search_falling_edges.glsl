#include "relaxed_cone.glsl"

void prepare(ivec2 texel) { write_map(vec4(search_falling_edges(texel))); }
