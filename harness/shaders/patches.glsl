#ifndef RELIEFBENCH_PATCHES_GLSL
#define RELIEFBENCH_PATCHES_GLSL

// What tessellation stages share: patch corners in, surface points out. Corners of a patch are in the order (0,0),
// (1,0), (0,1), (1,1) of gl_TessCoord.

#include "scene.glsl"
#include "taps.glsl"
#include "work.glsl"

#ifdef RELIEFBENCH_CONTROL
layout(location = 0) in vec2 vertex_corner[];
layout(location = 0) out vec2 control_corner[];

// For each invocation of the control stage.
void pass_corner() { control_corner[gl_InvocationID] = vertex_corner[gl_InvocationID]; }

void set_tessellation_factor(float factor) {
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelOuter[3] = factor;
    gl_TessLevelInner[0] = gl_TessLevelInner[1] = factor;
}
#endif

#ifdef RELIEFBENCH_EVALUATION
layout(location = 0) in vec2 control_corner[];
layout(location = 0) out vec3 surface;  // u, v, h

// Patch coordinates of this vertex on the even grid of the patches.
vec2 grid_coordinates() {
    return vec2(mix(control_corner[0].x, control_corner[1].x, gl_TessCoord.x),
                mix(control_corner[0].y, control_corner[2].y, gl_TessCoord.y));
}

// Ends the evaluation stage of one vertex.
void emit_surface(vec2 patch_uv, float h) {
    surface = vec3(patch_uv, h);
    gl_Position = scene.clip_from_world * vec4(surface_point(patch_uv, h), 1.0);
    count_stage();
}
#endif

#endif
