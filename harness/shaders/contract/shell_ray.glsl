#ifndef RELIEFBENCH_SHELL_RAY_GLSL
#define RELIEFBENCH_SHELL_RAY_GLSL

// What a technique of the shell sees: a straight piece of the pixel's ray within the shell, and the answers of relief.glsl.
// docs/adding_a_technique.md is its description.

#include "relief.glsl"

struct ShellRay {
    // Texture coordinates and height where the piece begins, s = 0, and what is travelled until it ends, s = 1. Pieces of
    // one ray overlap by what is lost to rounding, so that no crossing lies between them.
    vec3 place;
    vec3 way;
    bool from_base;  // it begins on the base, at h = 1
};

vec2 point_on_ray(ShellRay ray, float s) { return ray.place.xy + s * ray.way.xy; }

float height_of_ray(ShellRay ray, float s) { return ray.place.z + s * ray.way.z; }

#endif
