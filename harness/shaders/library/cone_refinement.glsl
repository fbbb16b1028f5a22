// From what a search along cones found to the answer, for techniques with the parameters `refinement` (none, linear,
// secant, binary), `secant_steps` and `binary_steps`.

#include "cone_march.glsl"

Trace refine(ReliefRay ray, ConeSearch search) {
    Refined refined = unrefined(search);
    if (holds_crossing(search)) {
        if (refinement == refinement_linear) refined = refine_linearly(ray, search.crossing);
        if (refinement == refinement_secant) refined = refine_by_secants(ray, search.crossing, secant_steps);
        if (refinement == refinement_binary) refined = refine_by_halving(ray, search.crossing, binary_steps);
    }
    return answer(search, refined);
}
