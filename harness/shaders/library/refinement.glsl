#ifndef RELIEFBENCH_REFINEMENT_GLSL
#define RELIEFBENCH_REFINEMENT_GLSL

// From a part of the ray that holds a crossing to a point: the refinements of the marching techniques, for whatever
// search found that part.

#include "crossing.glsl"

struct Refined {
    float s;
    int steps;  // those of the search and those of the refinement
};

// The surface between the ends is taken for a straight line, and ray and line are intersected (Luna 2012, section 4).
// Reads nothing.
Refined refine_linearly(Crossing crossing, float above, float below) {
    // At the entry both ends are one.
    float fraction = above + below > 0.0 ? above / (above + below) : 0.0;
    return Refined(mix(crossing.s_above, crossing.s_below, fraction), crossing.steps);
}

Refined refine_linearly(ReliefRay ray, Crossing crossing) {
    return refine_linearly(crossing, gap_above(ray, crossing), gap_below(ray, crossing));
}

#ifdef RELIEFBENCH_CONTRACT_1
Refined refine_linearly(Crossing crossing) {
    return refine_linearly(crossing, gap_above(crossing), gap_below(crossing));
}
#endif

// Which point of the interval that halving leaves is the answer, for techniques with the parameter `binary_answer` of
// compile time: its end above the surface, its end beneath (Policarpo 2005), else its middle (Policarpo 2007, Dykhta
// 2013), which halves the largest error.
float binary_answer_between(float s_above, float s_below) {
#if defined(BINARY_ANSWER_ABOVE)
    return s_above;
#elif defined(BINARY_ANSWER_BENEATH)
    return s_below;
#else
    return 0.5 * (s_above + s_below);
#endif
}

// `halvings` taps (Policarpo 2005).
Refined refine_by_halving(ReliefRay ray, Crossing crossing, int halvings) {
    float s_above = crossing.s_above;
    float s_below = crossing.s_below;
    for (int i = 0; i < halvings; ++i) {
        float middle = 0.5 * (s_above + s_below);
        if (tap_along(ray, middle) < height_of_ray(ray, middle))
            s_above = middle;
        else
            s_below = middle;
    }
    return Refined(binary_answer_between(s_above, s_below), crossing.steps + halvings);
}

// Ray and chord are intersected, and the intersection takes the place of the end on its side of the surface, again and
// again: the interval always holds a crossing (Risser 2007). The last of the `chords` intersections is the answer and
// is not read. One that is read and lies no further than `tolerance` from the surface, in units of the height scale, is the
// answer at once; at 0 none is.
Refined refine_by_secants(ReliefRay ray, Crossing crossing, int chords, float tolerance) {
    float above = gap_above(ray, crossing);
    float below = gap_below(ray, crossing);
    Refined refined = Refined(crossing.s_below, crossing.steps);
    for (int i = 1; i <= chords; ++i) {
        // Nothing is left to divide by where an end lies on the surface, the entry included.
        if (above <= 0.0 || below <= 0.0) break;
        refined.s = mix(crossing.s_above, crossing.s_below, above / (above + below));
        refined.steps += 1;
        if (i == chords) break;
        float gap = height_of_ray(ray, refined.s) - tap_along(ray, refined.s);
        if (tolerance > 0.0 && abs(gap) <= tolerance) break;
        if (gap > 0.0) {
            crossing.s_above = refined.s;
            above = gap;
        } else {
            crossing.s_below = refined.s;
            below = -gap;
        }
    }
    return refined;
}

Refined refine_by_secants(ReliefRay ray, Crossing crossing, int chords) {
    return refine_by_secants(ray, crossing, chords, 0.0);
}

// `levels` times the step that holds the crossing is marched again in `finer_steps` steps; the first of the finest at or
// beneath the surface (Riccardi), or, with the parameter `contact_answer` of compile time, the chord of the finest step.
// The last of the finer steps ends where contact is known already.
Refined refine_by_marching_again(ReliefRay ray, Crossing crossing, int levels, int finer_steps) {
    float s_above = crossing.s_above;
    float s_below = crossing.s_below;
    int steps = crossing.steps;
#ifdef CONTACT_ANSWER_CHORD
    float above = gap_above(ray, crossing);
    float below = gap_below(ray, crossing);
#endif
    // A ray that enters at or beneath the surface has no step to march again.
    for (int level = 0; level < levels && s_above < s_below; ++level) {
        float start = s_above;
        float end = s_below;
        for (int i = 1; i < finer_steps; ++i) {
            float s = mix(start, end, float(i) / float(finer_steps));
            steps += 1;
#ifdef CONTACT_ANSWER_CHORD
            float gap = height_of_ray(ray, s) - tap_along(ray, s);
            if (gap <= 0.0) {
                s_below = s;
                below = -gap;
                break;
            }
            s_above = s;
            above = gap;
#else
            if (tap_along(ray, s) >= height_of_ray(ray, s)) {
                s_below = s;
                break;
            }
            s_above = s;
#endif
        }
    }
#ifdef CONTACT_ANSWER_CHORD
    if (above > 0.0 && below > 0.0) return Refined(mix(s_above, s_below, above / (above + below)), steps);
#endif
    return Refined(s_below, steps);
}

#endif
