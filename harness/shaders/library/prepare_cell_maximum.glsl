#include "maximum_mip.glsl"

void prepare(ivec2 texel) { write_map(vec4(round_up(cell_maximum(texel)))); }
