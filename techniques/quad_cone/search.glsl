#include "quad_cone.glsl"

void prepare(ivec2 texel) { write_map(search_quadrants(texel)); }
