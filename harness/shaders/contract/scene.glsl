#ifndef RELIEFBENCH_SCENE_GLSL
#define RELIEFBENCH_SCENE_GLSL

// What is drawn and from where: the mirror of SceneUniforms in harness/technique/scene_uniforms.hpp.

const int max_lights = 3;

struct SceneValues {
    mat4 clip_from_world;
    vec3 eye;
    float height_scale;
    vec3 forward;  // of parallel rays: the direction of all of them
    float tiling;
    vec3 right;  // times tan(fov / 2) and the aspect ratio
    int parallel_rays;
    vec3 up;  // times tan(fov / 2)
    int light_count;
    vec4 light_direction[max_lights];  // unit vectors towards the lights
    vec4 light_colour[max_lights];
    vec3 ambient;
    float shininess;
    vec3 specular;
    float fog_start;
    vec3 fog_colour;
    float fog_range;  // 0: no fog
    ivec2 resolution;
    ivec2 patches_per_side;
    ivec2 first_patch;  // may be negative where the relief repeats past the unit square
    ivec2 patch_count;
#if defined(RELIEFBENCH_CURVED) || defined(RELIEFBENCH_FRAMES) || defined(RELIEFBENCH_POLYGON_HEIGHT)
    // Over a curved base, of parallel rays: the part of z = 0 that fills the picture, and the height from which they
    // start.
    vec2 window_low;
    vec2 window_size;
    float window_top;
#endif
#if defined(RELIEFBENCH_FRAMES) || defined(RELIEFBENCH_POLYGON_HEIGHT)
    int frame;   // of the sequence, from 0
    vec2 shift;  // of the pixels' rays, to the right and downwards, in fractions of the picture's sides
#endif
#ifdef RELIEFBENCH_POLYGON_HEIGHT
    float polygon_height;  // of the relief, at which the polygon lies
#endif
};

layout(set = 0, binding = 0, std140) uniform Scene {
    int index;  // always 0
    SceneValues values[1];
}
scene_block;

// Through the index where the harness says so (indexes_scene in harness/technique/program.hpp).
#ifdef RELIEFBENCH_INDEXED_SCENE
#define scene scene_block.values[scene_block.index]
#else
#define scene scene_block.values[0]
#endif

layout(constant_id = 0) const bool srgb_target = false;
layout(constant_id = 1) const bool lighting_enabled = true;
layout(constant_id = 2) const bool relief_repeats = false;

const int self_shadow_off = 0;
const int self_shadow_hard = 1;
const int self_shadow_dykhta = 2;
const int self_shadow_tatarchuk = 3;
layout(constant_id = 6) const int self_shadow = self_shadow_off;

// The ray of a pixel, from the camera alone: what the rasteriser interpolates would depend on its precision.
struct ViewRay {
    vec3 origin;     // the eye; of parallel rays the point in z = 0, or at the window's top
    vec3 direction;  // unit
    vec2 entry;      // patch coordinates where it crosses z = 0; over a curved base what the stage finds (enter_base)
    float entry_t;   // distance from `origin` to there
};

ViewRay view_ray(vec2 fragment) {
    vec2 across = fragment / vec2(scene.resolution);
#ifdef RELIEFBENCH_FRAMES
    across += scene.shift;
#endif
    if (scene.parallel_rays != 0) {
        vec2 entry = vec2(across.x, 1.0 - across.y);
#ifdef RELIEFBENCH_POLYGON_HEIGHT
        // The picture is filled where the polygon lies: that of the plane, whose window is the patch.
        entry += scene.forward.xy * ((1.0 - scene.polygon_height) * scene.height_scale / scene.forward.z);
#endif
#ifdef RELIEFBENCH_CURVED
        vec3 place = vec3(scene.window_low + entry * scene.window_size, 0.0);
        return ViewRay(place + scene.forward * (scene.window_top / scene.forward.z), scene.forward, vec2(0.0), 0.0);
#endif
        return ViewRay(vec3(entry - 0.5, 0.0), scene.forward, entry, 0.0);
    }
    vec3 direction =
        normalize(scene.forward + scene.right * (2.0 * across.x - 1.0) + scene.up * (1.0 - 2.0 * across.y));
#ifdef RELIEFBENCH_CURVED
    return ViewRay(scene.eye, direction, vec2(0.0), 0.0);
#endif
    float entry_t = -scene.eye.z / direction.z;
    return ViewRay(scene.eye, direction, scene.eye.xy + direction.xy * entry_t + 0.5, entry_t);
}

// Patch coordinates where a ray crosses the polygon.
vec2 polygon_entry(ViewRay view) {
#ifdef RELIEFBENCH_POLYGON_HEIGHT
    return view.entry - view.direction.xy * ((1.0 - scene.polygon_height) * scene.height_scale / view.direction.z);
#else
    return view.entry;
#endif
}

// S(u, v) of a height h. Over a curved base (u, v) does not name a point: it is the stage's to know the triangle.
#ifdef RELIEFBENCH_CURVED
vec3 surface_point(vec2 patch_uv, float h);
#else
vec3 surface_point(vec2 patch_uv, float h) { return vec3(patch_uv - 0.5, (h - 1.0) * scene.height_scale); }
#endif

bool inside_patch(vec2 patch_uv) {
    return all(greaterThanEqual(patch_uv, vec2(0.0))) && all(lessThanEqual(patch_uv, vec2(1.0)));
}

// Whether who goes on from `patch_uv` along `way` is outside of the patch for ever.
bool has_left_patch(vec2 patch_uv, vec2 way) {
    bvec2 below = bvec2(patch_uv.x < 0.0 && way.x <= 0.0, patch_uv.y < 0.0 && way.y <= 0.0);
    bvec2 above = bvec2(patch_uv.x > 1.0 && way.x >= 0.0, patch_uv.y > 1.0 && way.y >= 0.0);
    return any(below) || any(above);
}

#endif
