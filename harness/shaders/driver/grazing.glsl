#ifndef RELIEFBENCH_GRAZING_GLSL
#define RELIEFBENCH_GRAZING_GLSL

// What engines do where rays graze the base, instead of finding the outline.

#if defined(GRAZING_LIMIT) || defined(GRAZING_DAMP)
#define RELIEFBENCH_LIMITED_WAY 1
// Of a ray's way over the base: what is left of it under the largest slope, or where N.V is damped before it divides.
// `to_eye` is in the tangent frame.
float limited_way(vec3 to_eye) {
#ifdef GRAZING_LIMIT
    return min(1.0, grazing_max_slope * to_eye.z / max(length(to_eye.xy), 1e-20));
#else
    return to_eye.z / mix(to_eye.z, 1.0, grazing_damping);
#endif
}
#endif

#ifdef GRAZING_FADE
// 0: all of the relief; 1: none of it.
float grazing_fade_at(float n_dot_v) {
    if (n_dot_v <= grazing_end) return 1.0;
    return clamp((grazing_begin - n_dot_v) / max(grazing_begin - grazing_end, 1e-6), 0.0, 1.0);
}
#endif

#endif
