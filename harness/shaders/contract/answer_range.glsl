#ifndef RELIEFBENCH_ANSWER_RANGE_GLSL
#define RELIEFBENCH_ANSWER_RANGE_GLSL

// What a technique may answer (docs/adding_a_technique.md); probed compilations report what lies outside. The mirror of
// AnswerFault in harness/technique/answer_fault.hpp.

// By which s and h may leave [0, 1]: what a thousand additions of floats round.
const float answer_tolerance = 1e-4;
// No pixel takes more within the seconds that a pass is given.
const int answer_most_steps = 1 << 24;

const uint answer_fault_none = 0u;
const uint answer_fault_s = 1u;
const uint answer_fault_uv = 2u;
const uint answer_fault_h = 3u;
const uint answer_fault_steps = 4u;

// By its bits: a compiler may take isnan() to be false.
bool answer_is_finite(float value) { return (floatBitsToUint(value) & 0x7f800000u) != 0x7f800000u; }

bool answer_is_in_unit_range(float value) {
    return answer_is_finite(value) && value >= -answer_tolerance && value <= 1.0 + answer_tolerance;
}

// Of a point beside the ray or of real geometry. `bits` are those of the value at fault.
uint answer_fault_of_point(vec2 uv, float h, out uint bits) {
    bits = floatBitsToUint(answer_is_finite(uv.x) ? uv.y : uv.x);
    if (!answer_is_finite(uv.x) || !answer_is_finite(uv.y)) return answer_fault_uv;
    bits = floatBitsToUint(h);
    return answer_is_in_unit_range(h) ? answer_fault_none : answer_fault_h;
}

uint answer_fault_of_steps(int steps, out uint bits) {
    bits = uint(steps);
    return steps < 0 || steps > answer_most_steps ? answer_fault_steps : answer_fault_none;
}

#endif
