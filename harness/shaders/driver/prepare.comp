// One texel of one level of a derived map: the pass's prepare().

#include "taps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform PassRange {
    int level;
    int slice_begin;
    int slice_end;
    int first_row;  // of the level, in this dispatch
}
pass_range;

int level() { return pass_range.level; }

#ifdef RELIEFBENCH_VOLUME
#define RELIEFBENCH_TEXEL ivec3
#else
#define RELIEFBENCH_TEXEL ivec2
#endif

// Of the level being written.
RELIEFBENCH_TEXEL map_size() { return imageSize(target_map); }

void write_map_at(RELIEFBENCH_TEXEL texel, vec4 value) {
#ifdef RELIEFBENCH_PROBED
    // All the work, and nothing written; nobody who compiles it knows that.
    if (work.turns_asked > 0u) return;
#endif
    imageStore(target_map, texel, value);
}

RELIEFBENCH_TEXEL this_texel() {
    return RELIEFBENCH_TEXEL(ivec3(gl_GlobalInvocationID) + ivec3(0, pass_range.first_row, 0));
}

void write_map(vec4 value) { write_map_at(this_texel(), value); }

#ifdef RELIEFBENCH_FOLDS
// The texels of the height map that this dispatch searches, numbered row by row from 0: [slice_begin, slice_end).
int slice_begin() { return pass_range.slice_begin; }
int slice_end() { return pass_range.slice_end; }

// What the slices before wrote to this texel; undefined in the first, whose slice_begin() is 0.
vec4 folded_map() { return imageLoad(target_map, this_texel()); }
#endif

#ifdef RELIEFBENCH_ABOVE_BASE
layout(set = 0, binding = 7) uniform sampler2D previous_map;

// The next finer level of the map being written.
ivec2 previous_size() { return textureSize(previous_map, 0); }

// Clamped to its size.
vec4 previous_level(ivec2 texel) { return texelFetch(previous_map, clamp(texel, ivec2(0), previous_size() - 1), 0); }
#endif

void prepare(RELIEFBENCH_TEXEL texel);

#include "pass.glsl"

void main() {
    RELIEFBENCH_TEXEL texel = this_texel();
#ifdef RELIEFBENCH_PROBED
    // Cut until it has come to its end, as in count_begin().
    atomicAdd(work.stage_cuts, 1u);
#endif
    if (all(lessThan(texel, map_size()))) prepare(texel);
#ifdef RELIEFBENCH_PROBED
    if (!loops_are_cut()) atomicAdd(work.stage_cuts, ~0u);
#endif
}
