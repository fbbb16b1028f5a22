#ifndef RELIEFBENCH_SRGB_GLSL
#define RELIEFBENCH_SRGB_GLSL

// IEC 61966-2-1.
vec3 srgb_encode(vec3 linear) {
    vec3 value = clamp(linear, 0.0, 1.0);
    vec3 curve = 1.055 * pow(value, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * value, lessThanEqual(value, vec3(0.0031308)));
}

#endif
