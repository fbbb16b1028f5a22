#ifndef RELIEFBENCH_PIXEL_NOISE_GLSL
#define RELIEFBENCH_PIXEL_NOISE_GLSL

// Noise of a fragment's pixel in [0, 1), another one in each of its samples and in each frame of a sequence: what searches
// are jittered by.

#include "scene.glsl"
#include "taps.glsl"

layout(set = 0, binding = 59) uniform sampler2D blue_noise;  // a power of two on a side, made by the harness

// Which of the pixel's draws it is: the samples of one frame, then those of the next.
int draw_of_pixel() {
    int index = 0;
#ifdef RELIEFBENCH_FRAMES
    index = scene.frame;
#endif
#ifdef RELIEFBENCH_SAMPLES
    index = index * RELIEFBENCH_SAMPLES + gl_SampleID;
#endif
    return index;
}

// Interleaved gradient noise (Jimenez, Next Generation Post Processing in Call of Duty: Advanced Warfare, 2014). From draw
// to draw it moves across the picture by his step, for 64 of them.
float gradient_noise_of_pixel() {
    vec2 place = floor(gl_FragCoord.xy) + 5.588238 * float(draw_of_pixel() & 63);
    return fract(52.9829189 * fract(dot(place, vec2(0.06711056, 0.00583715))));
}

// One tap. From draw to draw each pixel's value goes on by the golden ratio, so that those of a few fill [0, 1) evenly.
float blue_noise_of_pixel() {
    ivec2 texel = ivec2(gl_FragCoord.xy) & (map_size(blue_noise, 0) - 1);
    return fract(tap_map_texel(blue_noise, texel, 0).r + 0.61803399 * float(draw_of_pixel()));
}

#endif
