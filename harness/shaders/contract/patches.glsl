#ifndef RELIEFBENCH_PATCHES_GLSL
#define RELIEFBENCH_PATCHES_GLSL

// What tessellation stages share: patch corners in, surface points out. A patch has `patch_corners` of them. Those of a
// quad are in the order (0,0), (1,0), (0,1), (1,1) of gl_TessCoord; those of a triangle, whose weights gl_TessCoord has,
// go counterclockwise as seen from above. Over a base that is not flat patches are its triangles.

#include "answer_range.glsl"
#include "scene.glsl"
#include "taps.glsl"
#include "work.glsl"

#ifdef RELIEFBENCH_CONTROL
layout(vertices = patch_corners) out;

layout(location = 0) in vec2 vertex_corner[];
layout(location = 0) out vec2 control_corner[];
#ifdef RELIEFBENCH_CURVED
layout(location = 1) in vec3 vertex_position[];  // in the world, on the base
layout(location = 2) in vec3 vertex_normal[];    // unit vectors
layout(location = 3) in int vertex_triangle[];
layout(location = 1) out vec3 control_position[];
layout(location = 2) out vec3 control_normal[];
layout(location = 3) out int control_triangle[];
#endif

// For each invocation of the control stage.
void pass_corner() {
    control_corner[gl_InvocationID] = vertex_corner[gl_InvocationID];
#ifdef RELIEFBENCH_CURVED
    control_position[gl_InvocationID] = vertex_position[gl_InvocationID];
    control_normal[gl_InvocationID] = vertex_normal[gl_InvocationID];
    control_triangle[gl_InvocationID] = vertex_triangle[gl_InvocationID];
#endif
}

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
#ifdef RELIEFBENCH_CURVED
layout(location = 1) in vec3 control_position[];
layout(location = 2) in vec3 control_normal[];
layout(location = 3) in int control_triangle[];
layout(location = 1) out vec3 surface_position;
layout(location = 2) flat out int surface_triangle;
#endif
// Where the harness says so (divides_by_own_w in harness/technique/program.hpp): what is interpolated is over w.
#ifdef RELIEFBENCH_OWN_PERSPECTIVE
layout(location = 3) out float one_over_w;
#endif

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

#ifdef RELIEFBENCH_CURVED
// Of the base at this vertex, with the same bits from both triangles at a side, as grid_coordinates.
vec3 between_corners(vec3 first, vec3 second, vec3 third) {
    precise vec3 between = gl_TessCoord.x * first + gl_TessCoord.y * second + gl_TessCoord.z * third;
    return between;
}

// Over the base at this vertex, wherever `patch_uv` says that h is from.
vec3 surface_point(vec2 patch_uv, float h) {
    precise vec3 normal = normalize(between_corners(control_normal[0], control_normal[1], control_normal[2]));
    precise vec3 point = between_corners(control_position[0], control_position[1], control_position[2]) +
                         ((h - 1.0) * scene.height_scale) * normal;
    return point;
}
#endif

// Ends the evaluation stage of one vertex.
void emit_surface(vec2 patch_uv, float h) {
    surface = vec3(patch_uv, h);
#ifdef RELIEFBENCH_CURVED
    surface_position = surface_point(patch_uv, h);
    surface_triangle = control_triangle[0];
#endif
    gl_Position = scene.clip_from_world * vec4(surface_point(patch_uv, h), 1.0);
#ifdef RELIEFBENCH_OWN_PERSPECTIVE
    one_over_w = 1.0 / gl_Position.w;
    surface *= one_over_w;
#ifdef RELIEFBENCH_CURVED
    surface_position *= one_over_w;
#endif
#endif
#ifdef RELIEFBENCH_PROBED
    uint bits;
    uint fault = answer_fault_of_point(patch_uv, h, bits);
    if (fault != answer_fault_none) count_stage_fault(fault, bits);
#endif
    count_stage();
}
#endif

#endif
