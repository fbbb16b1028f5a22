// The solid that stands in the relief (harness/scene/scene_object.hpp), met by each pixel's ray.

#include "scene.glsl"
#include "shading.glsl"
#include "srgb.glsl"

// The mirror of ObjectUniforms in harness/technique/object_draw.hpp.
layout(set = 0, binding = 7, std140) uniform Object {
    vec3 centre;
    float radius;
    vec3 half_size;
    vec3 colour;
}
object;

layout(constant_id = 11) const bool object_is_box = false;

layout(location = 0) out vec4 colour_target;

// Tells the object from the relief, which writes 1, and from nothing, which is 0.
const float object_alpha = 0.5;

// In place of the speed of a ray that stands still along an axis, so that nothing is divided by 0.
const float slowest = 1e-20;

struct Met {
    bool hit;
    float t;
    vec3 normal;
};

Met meet_sphere(ViewRay view) {
    vec3 to_centre = object.centre - view.origin;
    float nearest = dot(to_centre, view.direction);
    vec3 aside = to_centre - nearest * view.direction;
    float half_chord_squared = object.radius * object.radius - dot(aside, aside);
    float t = nearest - sqrt(max(half_chord_squared, 0.0));
    return Met(half_chord_squared >= 0.0, t, (view.origin + t * view.direction - object.centre) / object.radius);
}

// By slabs.
Met meet_box(ViewRay view) {
    vec3 direction = mix(view.direction, vec3(slowest), equal(view.direction, vec3(0.0)));
    vec3 middle = (object.centre - view.origin) / direction;
    vec3 half_way = abs(object.half_size / direction);
    vec3 first = middle - half_way;
    vec3 last = middle + half_way;
    float t = max(first.x, max(first.y, first.z));
    vec3 facing = vec3(equal(first, vec3(t))) * -sign(direction);
    return Met(t <= min(last.x, min(last.y, last.z)), t, normalize(facing));
}

void main() {
    ViewRay view = view_ray(gl_FragCoord.xy);
    Met met = object_is_box ? meet_box(view) : meet_sphere(view);
    // Parallel rays come from beyond their origin.
    if (!met.hit || (scene.parallel_rays == 0 && met.t < 0.0)) discard;

    vec4 clip = scene.clip_from_world * vec4(view.origin + met.t * view.direction, 1.0);
    // What stands before the near plane, which keeps to the relief, is in front of all of it.
    gl_FragDepth = max(clip.z / clip.w, 0.0);
    vec3 colour = object.colour;
    if (lighting_enabled) colour = shade(colour, met.normal, -view.direction, met.t, vec3(1.0));
    colour_target = vec4(srgb_target ? srgb_encode(colour) : colour, object_alpha);
}
