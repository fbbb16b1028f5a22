// One texel of one level of a derived map: the pass's prepare().

#include "taps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform PassLevel {
    int level;
}
pass_level;

int level() { return pass_level.level; }

// Of the level being written.
ivec2 map_size() { return imageSize(target_map); }

void write_map_at(ivec2 texel, vec4 value) { imageStore(target_map, texel, value); }

void write_map(vec4 value) { write_map_at(ivec2(gl_GlobalInvocationID.xy), value); }

#ifdef RELIEFBENCH_ABOVE_BASE
layout(set = 0, binding = 7) uniform sampler2D previous_map;

// The next finer level of the map being written.
ivec2 previous_size() { return textureSize(previous_map, 0); }

// Clamped to its size.
vec4 previous_level(ivec2 texel) { return texelFetch(previous_map, clamp(texel, ivec2(0), previous_size() - 1), 0); }
#endif

#include "pass.glsl"

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(texel, map_size()))) prepare(texel);
}
