#ifndef RELIEFBENCH_MATERIAL_GRADIENTS_GLSL
#define RELIEFBENCH_MATERIAL_GRADIENTS_GLSL

// What chooses the level of the material's mips: the gradients of harness/scene/material_filter.hpp.

#include "surface.glsl"

// How much longer than a pixel is wide the footprint of `analytic` is at most: what turns away from the eye further is taken
// to face it by 1 / max_stretch, and so is what an approximate answer finds on a slope that faces away.
const float max_stretch = 16.0;

#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
// Differences of the answers of neighbours in a quad of fragments, on every device those of this row and this column. All
// fragments of the quad must come here. Where one of the two does not take part, as it is beside the triangle, the difference
// is that at the entry.
void take_gradients_of_answers(vec2 answer, bool takes_part, vec2 entry_dx, vec2 entry_dy) {
    float part = takes_part ? 1.0 : 0.0;
    material_dx = dFdxFine(answer);
    material_dy = dFdyFine(answer);
    float other_part_x = dFdxFine(part);
    float other_part_y = dFdyFine(part);
    if (!takes_part || other_part_x != 0.0) material_dx = entry_dx;
    if (!takes_part || other_part_y != 0.0) material_dy = entry_dy;
}
#endif

#ifdef RELIEFBENCH_GRADIENTS_ANALYTIC
// Of a neighbour's ray that passes the level of the hit by `way` beside it: where it meets the tangent plane of a relief that
// rises by `slope` with the coordinates. `to_eye`: coordinates and height that the ray gains towards the eye.
vec2 way_over_slope(vec2 way, vec2 slope, vec3 to_eye, float least_facing) {
    float facing = to_eye.z - dot(slope, to_eye.xy);
    return way + to_eye.xy * (dot(slope, way) / max(facing, least_facing));
}

// `slope`: how the relief's offset along N changes with texture coordinates; `steepness`: the length of (slope, 1), per
// length. Rays meet the level of the hit as they meet the base, but for the distance at which perspective rays do so.
void take_gradients_of_slope(vec2 slope, float steepness, vec3 to_eye, float from_entry, vec2 entry_dx, vec2 entry_dy) {
    // What is flat faces the eye as the base does, however flat the ray.
    float least_facing = min(steepness / max_stretch, to_eye.z);
    material_dx = way_over_slope(from_entry * entry_dx, slope, to_eye, least_facing);
    material_dy = way_over_slope(from_entry * entry_dy, slope, to_eye, least_facing);
}
#endif

#endif
