#include "maximum_mip.glsl"

void prepare(ivec2 texel) { write_map(vec4(node_maximum(texel))); }
