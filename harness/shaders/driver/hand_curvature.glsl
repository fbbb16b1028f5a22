#ifndef RELIEFBENCH_HAND_CURVATURE_GLSL
#define RELIEFBENCH_HAND_CURVATURE_GLSL

// The curvature of the base as a user gives it, instead of what the mesh has: one number, or one for each of tangent and
// bitangent, in 1/patch side; positive where the base falls away.

#if defined(HAND_CURVATURE_CONSTANT) || defined(HAND_CURVATURE_PER_AXIS)
#define RELIEFBENCH_HAND_CURVATURE 1

// Second fundamental form of lengths along tangent and bitangent.
mat2 hand_fall() {
#ifdef HAND_CURVATURE_CONSTANT
    return mat2(curvature_along_u);
#else
    return mat2(curvature_along_u, 0.0, 0.0, curvature_along_v);
#endif
}
#endif

#endif
