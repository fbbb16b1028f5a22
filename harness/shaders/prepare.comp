// One texel of one level of a derived map: the pass's prepare().

#include "taps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform PassLevel {
    int level;
}
pass_level;

int level() { return pass_level.level; }

#ifdef RELIEFBENCH_VOLUME
#define RELIEFBENCH_TEXEL ivec3
#else
#define RELIEFBENCH_TEXEL ivec2
#endif

// Of the level being written.
RELIEFBENCH_TEXEL map_size() { return imageSize(target_map); }

void write_map_at(RELIEFBENCH_TEXEL texel, vec4 value) { imageStore(target_map, texel, value); }

void write_map(vec4 value) { write_map_at(RELIEFBENCH_TEXEL(gl_GlobalInvocationID), value); }

#ifdef RELIEFBENCH_ABOVE_BASE
layout(set = 0, binding = 7) uniform sampler2D previous_map;

// The next finer level of the map being written.
ivec2 previous_size() { return textureSize(previous_map, 0); }

// Clamped to its size.
vec4 previous_level(ivec2 texel) { return texelFetch(previous_map, clamp(texel, ivec2(0), previous_size() - 1), 0); }
#endif

#include "pass.glsl"

void main() {
    RELIEFBENCH_TEXEL texel = RELIEFBENCH_TEXEL(gl_GlobalInvocationID);
    if (all(lessThan(texel, map_size()))) prepare(texel);
}
