#include "maximum_mip.glsl"

void prepare(ivec2 texel) { write_map(vec4(texel_maximum(texel))); }
