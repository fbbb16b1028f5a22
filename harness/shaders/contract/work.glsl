#ifndef RELIEFBENCH_WORK_GLSL
#define RELIEFBENCH_WORK_GLSL

// Work counters of probed compilations (work_counters.glsl). Added to by atomics, so that discarded pixels keep their work
// and overdraw adds up.

#ifdef RELIEFBENCH_PROBED
#include "work_counters.glsl"

int work_index(ivec2 resolution, vec2 fragment) { return int(fragment.y) * resolution.x + int(fragment.x); }

// Around each search of a fragment. Its loops count as cut until it has come to its end: of a loop that has no way out a
// compiler drops what comes after.
void count_begin(ivec2 resolution, vec2 fragment) {
    atomicOr(work.pixels[work_index(resolution, fragment)].w, cut_bit);
}

void count_end(ivec2 resolution, vec2 fragment) {
    if (!loops_are_cut()) atomicAnd(work.pixels[work_index(resolution, fragment)].w, ~cut_bit);
}
#endif

// Of a fragment, at its search's end and before anything else is fetched.
void count_pixel(ivec2 resolution, vec2 fragment, int steps, bool converged) {
#ifdef RELIEFBENCH_PROBED
    int index = work_index(resolution, fragment);
    atomicAdd(work.pixels[index].x, counted_taps);
    atomicAdd(work.pixels[index].y, counted_texels);
    if ((work.pixels[index].w & fault_mask) == 0u) atomicAdd(work.pixels[index].z, uint(steps));
    atomicAdd(work.pixels[index].w, converged ? 0u : 1u);
    atomicOr(work.pixels[index].w, covered_bit);
    count_end(resolution, fragment);
    counted_taps = 0u;
    counted_texels = 0u;
#endif
}

#ifdef RELIEFBENCH_PROBED
// Of a pixel, whose first one stays. Its steps mean nothing any more.
void count_fault(ivec2 resolution, vec2 fragment, uint fault, uint bits) {
    int index = work_index(resolution, fragment);
    if ((work.pixels[index].w & fault_mask) != 0u) return;
    atomicOr(work.pixels[index].w, fault << fault_shift);
    atomicExchange(work.pixels[index].z, bits);
}

// Of a vertex. The draw keeps one of them.
void count_stage_fault(uint fault, uint bits) {
    if (atomicCompSwap(work.stage_fault, 0u, fault) == 0u) atomicExchange(work.stage_fault_bits, bits);
}
#endif

// Of an invocation of a vertex or tessellation stage, at its end. Their taps are counted as they are made.
void count_stage() {
#ifdef RELIEFBENCH_PROBED
    if (loops_are_cut()) atomicAdd(work.stage_cuts, 1u);
#endif
}

#endif
