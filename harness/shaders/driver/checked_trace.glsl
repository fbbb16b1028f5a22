#ifndef RELIEFBENCH_CHECKED_TRACE_GLSL
#define RELIEFBENCH_CHECKED_TRACE_GLSL

// The technique's trace() in fragment stages, for the eye and for lights: in probed compilations an answer out of its
// range is reported for the pixel.

#include "answer_range.glsl"
#include "relief.glsl"
#include "scene.glsl"
#include "work.glsl"

Trace trace(ReliefRay ray);

uint answer_fault_of(Trace found, out uint bits) {
    uint fault = answer_fault_none;
    bits = floatBitsToUint(found.s);
    if (found.kind == trace_on_ray && !answer_is_in_unit_range(found.s)) fault = answer_fault_s;
    if (found.kind == trace_off_ray) fault = answer_fault_of_point(found.uv, found.h, bits);
    return fault != answer_fault_none ? fault : answer_fault_of_steps(found.steps, bits);
}

#ifdef RELIEFBENCH_BENT_RAY
// Of an s between 0 and s_end.
uint answer_fault_of(ReliefRay ray, Trace found, out uint bits) {
    Trace of_whole_way = found;
    of_whole_way.s /= end_of_ray(ray);
    uint fault = answer_fault_of(of_whole_way, bits);
    if (fault == answer_fault_s) bits = floatBitsToUint(found.s);
    return fault;
}
#endif

Trace checked_trace(ReliefRay ray) {
    Trace found = trace(ray);
#ifdef RELIEFBENCH_PROBED
    uint bits;
#ifdef RELIEFBENCH_BENT_RAY
    uint fault = answer_fault_of(ray, found, bits);
#else
    uint fault = answer_fault_of(found, bits);
#endif
    if (fault != answer_fault_none) count_fault(scene.resolution, gl_FragCoord.xy, fault, bits);
#endif
    return found;
}

#endif
