#ifndef RELIEFBENCH_PATCHES_GLSL
#define RELIEFBENCH_PATCHES_GLSL

// What tessellation stages share: patch corners in, surface points out. A patch has `patch_corners` of them. Those of a
// quad are in the order (0,0), (1,0), (0,1), (1,1) of gl_TessCoord; those of a triangle, whose weights gl_TessCoord has,
// go counterclockwise as seen from above.

#include "answer_range.glsl"
#include "scene.glsl"
#include "taps.glsl"
#include "work.glsl"

#ifdef RELIEFBENCH_CONTROL
layout(vertices = patch_corners) out;

layout(location = 0) in vec2 vertex_corner[];
layout(location = 0) out vec2 control_corner[];

// For each invocation of the control stage.
void pass_corner() { control_corner[gl_InvocationID] = vertex_corner[gl_InvocationID]; }

// The loops that lead to a factor have ended when it is set: a stage that does not count itself is counted here.
void set_tessellation_factor(float factor) {
#ifdef RELIEFBENCH_PROBED
    count_stage();
#endif
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelOuter[3] = factor;
    gl_TessLevelInner[0] = gl_TessLevelInner[1] = factor;
}

// Of the sides of a quad between corners 0 and 2, 0 and 1, 1 and 3, 2 and 3. The inside is as fine as the finer of two
// opposite sides.
void set_side_factors(vec4 sides) {
#ifdef RELIEFBENCH_PROBED
    count_stage();
#endif
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = sides[i];
    gl_TessLevelInner[0] = max(sides[1], sides[3]);
    gl_TessLevelInner[1] = max(sides[0], sides[2]);
}

// Of the sides of a triangle between corners 1 and 2, 2 and 0, 0 and 1.
void set_side_factors(vec3 sides) {
#ifdef RELIEFBENCH_PROBED
    count_stage();
#endif
    for (int i = 0; i < 3; ++i) gl_TessLevelOuter[i] = sides[i];
    gl_TessLevelInner[0] = max(sides.x, max(sides.y, sides.z));
}

// The patch is not drawn.
void drop_patch() { set_tessellation_factor(0.0); }

// Pixels along the picture's height that a sphere of `diameter` around a point spans. Parallel rays see as many
// everywhere, as many as a horizontal line of that length at most.
float pixels_across(vec3 centre, float diameter) {
    precise float pixels;
    if (scene.parallel_rays != 0) {
        pixels = diameter * float(max(scene.resolution.x, scene.resolution.y));
    } else {
        const float nearest = 1e-3;
        float depth = max(dot(centre - scene.eye, scene.forward), nearest);
        // `up` is as long as half the picture's height at depth 1.
        pixels = diameter * float(scene.resolution.y) / (2.0 * length(scene.up) * depth);
    }
    return pixels;
}
#endif

#ifdef RELIEFBENCH_EVALUATION
layout(location = 0) in vec2 control_corner[];
layout(location = 0) out vec3 surface;  // u, v, h

// Patch coordinates of this vertex on the even grid of the patches. Two patches get the same ones, bit for bit, for a
// vertex on the side between them: products and sums as written, terms of the side in either order, all others zero.
vec2 grid_coordinates() {
    precise vec2 grid;
    if (patch_corners == 3) {
        grid = gl_TessCoord.x * control_corner[0] + gl_TessCoord.y * control_corner[1] +
               gl_TessCoord.z * control_corner[2];
    } else {
        vec2 low = control_corner[0];
        vec2 high = vec2(control_corner[1].x, control_corner[2].y);
        grid = (1.0 - gl_TessCoord.xy) * low + gl_TessCoord.xy * high;
    }
    return grid;
}

// Ends the evaluation stage of one vertex.
void emit_surface(vec2 patch_uv, float h) {
    surface = vec3(patch_uv, h);
    gl_Position = scene.clip_from_world * vec4(surface_point(patch_uv, h), 1.0);
#ifdef RELIEFBENCH_PROBED
    uint bits;
    uint fault = answer_fault_of_point(patch_uv, h, bits);
    if (fault != answer_fault_none) count_stage_fault(fault, bits);
#endif
    count_stage();
}
#endif

#endif
