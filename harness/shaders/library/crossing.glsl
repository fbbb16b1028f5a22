#ifndef RELIEFBENCH_CROSSING_GLSL
#define RELIEFBENCH_CROSSING_GLSL

#include "relief.glsl"

// A part of the ray that holds a crossing of the surface: its upper end lies above the surface, its lower end at or
// beneath it. Where the ray enters at or beneath the surface both ends are the entry.
struct Crossing {
    float s_above;
    float h_above;  // the surface's height over that end
    float s_below;
    float h_below;
    int steps;  // of the search so far
};

// The surface's height over the ray's point at parameter s. Whoever includes this file defines how it is read.
float tap_along(ReliefRay ray, float s);

// How far the ends lie above and beneath the surface, in units of the height scale: positive, or 0 on the surface.
float gap_above(ReliefRay ray, Crossing crossing) { return height_of_ray(ray, crossing.s_above) - crossing.h_above; }
float gap_below(ReliefRay ray, Crossing crossing) { return crossing.h_below - height_of_ray(ray, crossing.s_below); }

#ifdef RELIEFBENCH_CONTRACT_1
float gap_above(Crossing crossing) { return (1.0 - crossing.s_above) - crossing.h_above; }
float gap_below(Crossing crossing) { return crossing.h_below - (1.0 - crossing.s_below); }
#endif

#endif
