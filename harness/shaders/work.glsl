#ifndef RELIEFBENCH_WORK_GLSL
#define RELIEFBENCH_WORK_GLSL

// Work counters of probed compilations: the mirror of WorkCounters in harness/technique/draw.cpp. Added to by atomics,
// so that discarded pixels keep their work and overdraw adds up.

#ifdef RELIEFBENCH_PROBED
layout(set = 0, binding = 5, std430) buffer Work {
    uint stage_taps;  // of vertex and tessellation stages, summed over the draw
    uint stage_texels;
    uint unused_0;
    uint unused_1;
    uvec4 pixels[];  // taps, texels, steps, searches that ended by their cap | covered
}
work;

const uint covered_bit = 0x80000000u;
#endif

// Of a fragment, after its search and before anything else is fetched.
void count_pixel(ivec2 resolution, vec2 fragment, int steps, bool converged) {
#ifdef RELIEFBENCH_PROBED
    ivec2 pixel = ivec2(fragment);
    int index = pixel.y * resolution.x + pixel.x;
    atomicAdd(work.pixels[index].x, counted_taps);
    atomicAdd(work.pixels[index].y, counted_texels);
    atomicAdd(work.pixels[index].z, uint(steps));
    atomicAdd(work.pixels[index].w, converged ? 0u : 1u);
    atomicOr(work.pixels[index].w, covered_bit);
    counted_taps = 0u;
    counted_texels = 0u;
#endif
}

// Of an invocation of a vertex or tessellation stage, at its end.
void count_stage() {
#ifdef RELIEFBENCH_PROBED
    atomicAdd(work.stage_taps, counted_taps);
    atomicAdd(work.stage_texels, counted_texels);
    counted_taps = 0u;
    counted_texels = 0u;
#endif
}

#endif
