#ifndef RELIEFBENCH_SHADING_GLSL
#define RELIEFBENCH_SHADING_GLSL

// The one shading model of harness/scene/lighting.hpp; harness/reference/shading.cpp is the same in C++.

#include "scene.glsl"

// Linear RGB. `normal` and `to_eye` are unit vectors, `t` is the distance along the ray; `visibility` says how much of
// each light arrives.
vec3 shade(vec3 albedo, vec3 normal, vec3 to_eye, float t, vec3 visibility) {
    vec3 diffuse = scene.ambient;
    vec3 specular = vec3(0.0);
    for (int i = 0; i < scene.light_count; ++i) {
        vec3 to_light = scene.light_direction[i].xyz;
        vec3 light = scene.light_colour[i].rgb;
        if (self_shadow != self_shadow_off) light *= visibility[i];
        float n_dot_l = dot(normal, to_light);
        if (n_dot_l <= 0.0) continue;
        diffuse += light * n_dot_l;
        float n_dot_h = dot(normal, normalize(to_light + to_eye));
        if (n_dot_h > 0.0) specular += light * scene.specular * pow(n_dot_h, scene.shininess);
    }
    vec3 colour = albedo * diffuse + specular;
    if (scene.fog_range > 0.0)
        colour = mix(colour, scene.fog_colour, clamp((t - scene.fog_start) / scene.fog_range, 0.0, 1.0));
    return colour;
}

// `derivatives` of the height by texture coordinate.
vec3 shading_normal(vec2 derivatives) {
    return normalize(vec3(-scene.height_scale * scene.tiling * derivatives, 1.0));
}

#endif
