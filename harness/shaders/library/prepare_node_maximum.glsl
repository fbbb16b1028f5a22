#include "maximum_mip.glsl"

void prepare(ivec2 node) { write_map(vec4(node_maximum(node))); }
