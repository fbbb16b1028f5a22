#ifndef RELIEFBENCH_RELIEF_GLSL
#define RELIEFBENCH_RELIEF_GLSL

// What a per-pixel technique sees: a ray entering the relief in tangent space, and the ways to answer.
// docs/adding_a_technique.md is its description.

#include "taps.glsl"
// The manifest says to which contract the technique is written.
#ifdef RELIEFBENCH_CONTRACT_1
#include "relief_ray_1.glsl"
#else
#include "relief_ray.glsl"
#endif

// A ray that enters the relief over a height of at least 1 - this has hit it there, at s = 0: the mirror of
// entry_tolerance in harness/scene/relief.hpp. A search that starts with a look at the entry asks enters_surface.
const float entry_tolerance = 1.0 / 1048576.0;

bool enters_surface(float h) { return h >= 1.0 - entry_tolerance; }

const int trace_miss = 0;
const int trace_on_ray = 1;
const int trace_off_ray = 2;

struct Trace {
    int kind;
    float s;  // on the ray
    vec2 uv;  // off the ray: texture coordinates and height
    float h;
    int steps;
    bool converged;    // false when the search ended by its cap
    bool flat_normal;  // shade with the polygon's normal
};

Trace hit_on_ray(float s, int steps) { return Trace(trace_on_ray, s, vec2(0.0), 0.0, steps, true, false); }

Trace hit_off_ray(vec2 uv, float h, int steps) { return Trace(trace_off_ray, 0.0, uv, h, steps, true, false); }

Trace miss(int steps) { return Trace(trace_miss, 0.0, vec2(0.0), 0.0, steps, true, false); }

Trace unconverged(Trace result) {
    result.converged = false;
    return result;
}

// As samplers choose it without anisotropy.
float footprint_level(vec2 uv_dx, vec2 uv_dy) {
    vec2 size = vec2(height_map_size());
    return log2(max(length(uv_dx * size), length(uv_dy * size)));
}

#endif
