#include "quick_cone.glsl"

void prepare(ivec2 texel) { write_map(vec4(quick_cone(maxima, texel, quick_radius))); }
