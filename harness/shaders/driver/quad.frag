// A per-pixel technique: its trace() from the ray of this pixel, then the boundary, the depth, the shadows and the colour.

#include "grazing.glsl"
#include "lod_fade.glsl"
#ifdef RELIEFBENCH_MATERIAL_MIPS
#include "material_gradients.glsl"
#endif
#ifndef RELIEFBENCH_CURVED
#include "plane_ray.glsl"
#endif
#include "relief.glsl"
#include "scene.glsl"
#include "surface.glsl"
#ifdef RELIEFBENCH_CURVED
#include "curved_ray.glsl"

layout(location = 0) flat in int triangle_index;

// The largest depth before that of nothing.
const float deepest = 0.99999994;
#endif
#ifdef RELIEFBENCH_PROBED
#include "work.glsl"
// A pixel that a technique discards has done its work all the same.
void discard_counted() {
    count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
    discard;
}
#define discard discard_counted()
#endif
#include "trace.glsl"
#undef discard
#ifdef RELIEFBENCH_EYE_DISTANCE
float eye_distance() {
#ifdef RELIEFBENCH_CURVED
    return scene.parallel_rays != 0 ? 0.0 : distance(scene.eye, curved_entry.point);
#else
    return view_ray(gl_FragCoord.xy).entry_t;
#endif
}
#endif
#include "self_shadow.glsl"
#include "work.glsl"

#ifdef RELIEFBENCH_BENT_RAY
// Whether the ray is beside the base from s on.
bool has_left_base(ReliefRay ray, float s) {
    vec2 place = point_on_ray(ray, s) / scene.tiling;
#ifdef RELIEFBENCH_CURVED
    return has_left_base(place, way_of_ray(ray, s)) && has_left_base(place, way_of_ray(ray, ray.s_end));
#else
    return has_left_patch(place, way_of_ray(ray, s)) && has_left_patch(place, way_of_ray(ray, ray.s_end));
#endif
}
#endif

#if defined(RELIEFBENCH_CURVED) && defined(RELIEFBENCH_GRADIENTS_FROM_RESULT)
// Whether this fragment searches, and whether its answer counts for its neighbours: not that of one beside the triangle, for
// which some devices read no buffer, and others run all of the shader.
bool searches = false;
bool takes_part = false;
#endif

#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
// The texture coordinates that the search ends with: a miss is where its ray leaves the relief.
vec2 answer_of(ReliefRay ray, Trace found) {
    if (found.kind == trace_off_ray) return found.uv;
    return point_on_ray(ray, found.kind == trace_on_ray ? found.s : end_of_ray(ray));
}
#endif

#ifdef RELIEFBENCH_GRADIENTS_ANALYTIC
// Of an answer at distance `t`; they fade as the relief does.
void take_gradients_at(vec2 uv, float t, ViewRay view, ReliefRay ray, float relief_left) {
#ifdef RELIEFBENCH_CURVED
    vec3 to_eye = way_over_base(-view.direction) * vec3(scene.tiling, scene.tiling, 1.0);
    mat2 uv_per_length = ray.uv_per_length;
#else
    vec3 to_eye = -view.direction * vec3(scene.tiling, scene.tiling, 1.0);
    mat2 uv_per_length = mat2(scene.tiling);
#endif
    vec2 slope = relief_left > 0.0 ? slope_over_footprint(uv, ray.uv_dx, ray.uv_dy) : vec2(0.0);
    float from_entry = scene.parallel_rays != 0 ? 1.0 : t / view.entry_t;
    take_gradients_of_slope(slope, length(vec3(slope * uv_per_length, 1.0)), to_eye, from_entry, ray.uv_dx, ray.uv_dy);
    material_dx = mix(from_entry * ray.uv_dx, material_dx, relief_left);
    material_dy = mix(from_entry * ray.uv_dy, material_dy, relief_left);
}
#endif

#ifdef RELIEFBENCH_CONSERVATIVE_DEPTH
layout(depth_greater) out float gl_FragDepth;
#endif

#ifdef RELIEFBENCH_CURVED
// Of a ray that has entered the base.
void draw_relief(ViewRay view) {
    float t_per_s = scene.height_scale / -way_over_base(view.direction).z;
    vec2 offset = curved_offset(-view.direction);
#ifdef RELIEFBENCH_LIMITED_WAY
    float left_way = limited_way(-view.direction * curved_entry.frame);
    offset *= left_way;
#endif
    vec2 max_offset = offset / scene.tiling;
    vec2 uv_dx = scene.tiling * curved_entry.uv_dx;
    vec2 uv_dy = scene.tiling * curved_entry.uv_dy;
    ReliefRay ray = curved_ray(scene.tiling * view.entry, offset, -view.direction, uv_dx, uv_dy,
                               footprint_level(uv_dx, uv_dy));
#else
void main() {
    ViewRay view = view_ray(gl_FragCoord.xy);
    float t_per_s = scene.height_scale / -view.direction.z;
    vec2 max_offset = view.direction.xy * t_per_s;
#ifdef RELIEFBENCH_LIMITED_WAY
    float left_way = limited_way(-view.direction);
#ifdef RELIEFBENCH_POLYGON_HEIGHT
    // Where the polygon lies nothing moves.
    view.entry += (1.0 - scene.polygon_height) * (1.0 - left_way) * max_offset;
#endif
    max_offset *= left_way;
#endif

    vec2 uv = scene.tiling * view.entry;
    vec2 uv_dx = dFdx(uv);
    vec2 uv_dy = dFdy(uv);
    ReliefRay ray = plane_ray(uv, scene.tiling * max_offset, -view.direction, uv_dx, uv_dy,
                              footprint_level(uv_dx, uv_dy));
#endif
#ifdef RELIEFBENCH_BENT_RAY
    bend_ray(ray, bend_of(ray.straight_offset), uv_bend_of(ray.straight_offset));
#endif
    float fade = lod_fade_at(ray, view.entry_t);
#ifdef GRAZING_FADE
    fade = max(fade, grazing_fade_at(ray.to_eye.z));
#endif
#ifdef RELIEFBENCH_PROBED
    count_begin(scene.resolution, gl_FragCoord.xy);
#endif
#if defined(RELIEFBENCH_CURVED) && defined(RELIEFBENCH_GRADIENTS_FROM_RESULT)
    Trace found = miss(0);
    if (searches) found = trace_faded(ray, fade);
#else
    Trace found = trace_faded(ray, fade);
#endif
#ifdef RELIEFBENCH_PROBED
    // Only a search that could still hit something counts as unconverged. Its ray parameter is that before the fade.
    if (found.kind == trace_on_ray && !found.converged && !relief_repeats)
#ifdef RELIEFBENCH_BENT_RAY
        found.converged = has_left_base(ray, unfaded(found.s, fade));
#elif defined(RELIEFBENCH_CURVED)
        found.converged = has_left_base(view.entry + unfaded(found.s, fade) * max_offset, max_offset);
#else
        found.converged = has_left_patch(view.entry + unfaded(found.s, fade) * max_offset, max_offset);
#endif
#endif
    count_pixel(scene.resolution, gl_FragCoord.xy, found.steps, found.converged);
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
    // Before any of the quad is discarded.
#ifdef RELIEFBENCH_CURVED
    take_gradients_of_answers(answer_of(ray, found), takes_part, ray.uv_dx, ray.uv_dy);
#else
    take_gradients_of_answers(answer_of(ray, found), true, ray.uv_dx, ray.uv_dy);
#endif
#endif
    if (found.kind == trace_miss) discard;

    vec4 hit;
    if (found.kind == trace_on_ray) {
#ifdef RELIEFBENCH_BENT_RAY
        hit = vec4(point_on_ray(ray, found.s) / scene.tiling, height_of_ray(ray, found.s),
                   view.entry_t + found.s * t_per_s);
#ifndef RELIEFBENCH_CURVED
        // Over the plane it is bent by hand: its points lie beside the pixel's ray.
        hit.w = dot(surface_point(hit.xy, hit.z) - view.origin, view.direction);
#endif
#else
        hit = vec4(view.entry + found.s * max_offset, height_of_ray(ray, found.s), view.entry_t + found.s * t_per_s);
#endif
#ifdef RELIEFBENCH_LIMITED_WAY
        // A ray whose way is shortened is not where its answer lies.
        if (left_way < 1.0) hit.w = dot(surface_point(hit.xy, hit.z) - view.origin, view.direction);
#endif
    } else {
        hit = vec4(found.uv / scene.tiling, found.h, 0.0);
        hit.w = dot(surface_point(hit.xy, hit.z) - view.origin, view.direction);
    }
    // Never negative, which would be a miss: parallel rays start on the polygon, where rounding decides the sign.
    hit.w = max(0.0, hit.w);
#ifdef RELIEFBENCH_CURVED
    if (!relief_repeats && !inside_base(hit.xy)) discard;
#else
    if (!relief_repeats && !inside_patch(hit.xy)) discard;
#endif
#ifdef TEXTURE_BOUNDS_CLIP
    if (!inside_patch(hit.xy)) discard;
#endif
#ifdef RELIEFBENCH_GRADIENTS_BEFORE_SEARCH
    material_dx = ray.uv_dx;
    material_dy = ray.uv_dy;
#elif defined(RELIEFBENCH_GRADIENTS_ANALYTIC)
    take_gradients_at(scene.tiling * hit.xy, hit.w, view, ray, found.flat_normal ? 0.0 : 1.0 - fade);
#endif

#ifdef RELIEFBENCH_WRITE_DEPTH
#ifdef RELIEFBENCH_CURVED
    vec4 clip = scene.clip_from_world * vec4(view.origin + hit.w * view.direction, 1.0);
    // A straight ray may hit below all that the base and its floor span: there it is still nearer than nothing.
    float depth = min(clip.z / clip.w, deepest);
#else
    vec4 clip = scene.clip_from_world * vec4(surface_point(hit.xy, hit.z), 1.0);
    float depth = clip.z / clip.w;
#endif
#ifdef RELIEFBENCH_CONSERVATIVE_DEPTH
    // The relief lies beneath its polygon; but rounding, and an answer beside the ray, may come out nearer.
    depth = max(depth, gl_FragCoord.z);
#endif
    gl_FragDepth = depth;
#endif
#ifdef RELIEFBENCH_PROBED
    // The searches of its shadows are this invocation's, too.
    count_begin(scene.resolution, gl_FragCoord.xy);
#endif
    // The polygon has no shadows; those of the relief fade with it.
    vec3 visibility = vec3(1.0);
    if (!found.flat_normal && fade < 1.0) visibility = mix(light_visibility(hit.xy, ray), visibility, fade);
#ifdef RELIEFBENCH_PROBED
    count_end(scene.resolution, gl_FragCoord.xy);
#endif
#ifdef RELIEFBENCH_CURVED
    vec3 normal = found.flat_normal ? curved_entry.frame[2] : curved_normal(hit.xy, surface_slope(hit.xy));
    write_surface(hit, view.direction, normal, visibility);
#else
    write_surface(hit, view.direction, found.flat_normal, visibility);
#endif
}

#ifdef RELIEFBENCH_CURVED
void main() {
    ViewRay view = view_ray(gl_FragCoord.xy);
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
    // All of the quad go on to where answers are compared.
    searches = enter_base(view, triangle_index);
    takes_part = searches && depth_in_triangle(uint(triangle_index), view.entry) > -chart_gap;
    draw_relief(view);
#else
    // In a branch, not past a discard: a device may run a fragment's neighbours beside the triangle with it, for which no
    // buffer is read, and their searches, of no numbers, would go on until its loops are ended.
    if (enter_base(view, triangle_index)) {
        draw_relief(view);
    } else {
        // Seen from behind its normals, though not from behind its facet.
        count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
        discard;
    }
#endif
}
#endif
