#ifndef RELIEFBENCH_WORK_COUNTERS_GLSL
#define RELIEFBENCH_WORK_COUNTERS_GLSL

// What probed compilations count in: the mirror of harness/technique/work_counters.hpp.

layout(set = 0, binding = 5, std430) buffer Work {
    uint stage_taps;  // of vertex and tessellation stages, summed over the draw
    uint stage_texels;
    uint turns_asked;  // only read: what the loop of loops_are_cut() counts to
    uint stage_cuts;   // invocations of those stages, or of a preparation pass, whose loops the device ended
    uint stage_fault;  // answer_range.glsl: of a vertex, and the bits of its value
    uint stage_fault_bits;
    uint unused_0;
    uint unused_1;
    // taps; texels; steps, or of an answer out of range the bits of its value; searches that ended by their cap | its fault |
    // cut | covered
    uvec4 pixels[];
}
work;

const uint covered_bit = 0x80000000u;
const uint cut_bit = 0x40000000u;
const int fault_shift = 27;
const uint fault_mask = 0x38000000u;

// Of a fragment, so far.
uint counted_taps = 0u;
uint counted_texels = 0u;

// Whether the device has ended this invocation's loops. One that does (harness/gpu/loop_limit.hpp) gives an invocation, with
// those that it runs beside it, so many iterations of all loops together; then every loop ends after one. So one more loop
// tells, whatever loops there were before. Nobody who compiles it knows where it ends.
bool loops_are_cut() {
    uint turns = 0u;
    while (turns < work.turns_asked) turns += 1u;
    return turns != work.turns_asked;
}

#endif
