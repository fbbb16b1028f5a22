#ifndef RELIEFBENCH_SELF_SHADOW_GLSL
#define RELIEFBENCH_SELF_SHADOW_GLSL

// How much of each light reaches a point of the relief past the relief itself: the methods of
// harness/scene/self_shadow.hpp, over the technique's own trace() where its shadow_search is own.

#include "checked_trace.glsl"
#ifdef RELIEFBENCH_CURVED
#include "curved_ray.glsl"
#else
#include "plane_ray.glsl"
#endif
#include "relief.glsl"
#include "scene.glsl"

layout(constant_id = 7) const float self_shadow_bias = 0.0;
layout(constant_id = 8) const int self_shadow_min_steps = 1;
layout(constant_id = 9) const int self_shadow_max_steps = 1;
layout(constant_id = 10) const float self_shadow_softening = 0.0;

// Dykhta's lighting raises the factor to this power.
const float dykhta_contrast = 4.0;

// Of the DirectX SDK's sample: where along the light's way the heights are taken, and how much each one counts.
const int tatarchuk_taps = 7;
const float tatarchuk_distances[tatarchuk_taps] = float[](0.88, 0.77, 0.66, 0.55, 0.44, 0.33, 0.22);
const float tatarchuk_weights[tatarchuk_taps] = float[](1.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0);
// What stays of the light in its deepest shadow.
const float tatarchuk_least = 0.4;

// Nothing beyond the border of a clipped patch shadows it.
#ifdef RELIEFBENCH_CURVED
bool casts_shadow(vec2 uv) { return relief_repeats || inside_base(uv / scene.tiling); }
#else
bool casts_shadow(vec2 uv) { return relief_repeats || inside_patch(uv / scene.tiling); }
#endif

// More layers the lower the light stands (Dykhta 2013).
float shadow_layers(vec3 to_light) {
    return mix(float(self_shadow_max_steps), float(self_shadow_min_steps), to_light.z);
}

// Where a ray from the light enters the relief that is there: at h = 1, or through the side of a clipped patch.
float enter_relief(ReliefRay ray, float s_point) {
    if (relief_repeats) return 0.0;
    vec2 offset = straight_offset(ray);
    vec2 side = vec2(greaterThan(-offset, vec2(0.0))) * scene.tiling;
    // Of a ray along an axis the other one's quotient is infinite or, on the border itself, no number: neither counts.
    vec2 s = (side - ray.uv) / offset;
    float first = max(offset.x == 0.0 ? 0.0 : s.x, offset.y == 0.0 ? 0.0 : s.y);
    return clamp(first, 0.0, s_point);
}

#ifdef RELIEFBENCH_BENT_RAY
// How far before the point a coordinate that is `inside` of its side there has passed it; the whole way if it has not.
float way_to_side(float inside, float way, float bend, float whole) {
    float discriminant = way * way - 4.0 * bend * inside;
    if (way == 0.0 || discriminant < 0.0) return whole;
    float before = 2.0 * inside / (way + sign(way) * sqrt(discriminant));
    return before >= 0.0 ? before : whole;
}

// The same of a bent ray, from the point back to the light.
float enter_relief_bent(ReliefRay ray, float s_point) {
    if (relief_repeats) return 0.0;
    vec2 point = point_on_ray(ray, s_point);
    vec2 way = way_of_ray(ray, s_point);
    vec2 inside = point - vec2(greaterThan(-way, vec2(0.0))) * scene.tiling;
    float before = min(way_to_side(inside.x, way.x, ray.uv_bend.x, s_point),
                       way_to_side(inside.y, way.y, ray.uv_bend.y, s_point));
    return clamp(s_point - before, 0.0, s_point);
}
#endif

#ifdef RELIEFBENCH_CHARTS
// Of a chart's border, which has any shape: how finely it is looked for.
const int border_steps = 32;
const int border_halvings = 8;

// The same where the patch is a chart: from the point back to the light until it ends.
float enter_chart(ReliefRay ray, float s_point) {
    if (relief_repeats) return 0.0;
    for (int i = 1; i <= border_steps; ++i) {
        float s = s_point * (1.0 - float(i) / float(border_steps));
        if (casts_shadow(point_on_ray(ray, s))) continue;
        float inside = s_point * (1.0 - float(i - 1) / float(border_steps));
        for (int halving = 0; halving < border_halvings; ++halving) {
            float middle = 0.5 * (s + inside);
            if (casts_shadow(point_on_ray(ray, middle))) inside = middle;
            else s = middle;
        }
        return inside;
    }
    return 0.0;
}
#endif

// The harness's own search from `s_first` towards the point, in uniform layers: whether the ray passes from above the
// surface to beneath it before `s_end`.
bool march_to_point(ReliefRay ray, float s_first, float s_point, float s_end) {
    int layers = max(1, int(shadow_layers(ray.to_eye)));
    bool above = s_first == 0.0;
    for (int i = 0; i < layers; ++i) {
        float s = mix(s_first, s_point, float(i) / float(layers));
        if (s >= s_end) return false;
        float h = tap_height(point_on_ray(ray, s));
        bool beneath = s == 0.0 ? enters_surface(h) : h > height_of_ray(ray, s);
        if (above && beneath) return true;
        above = !beneath;
    }
    return false;
}

// 1 where the ray of the light through the point meets nothing before it, else 0.
float hard_visibility(ReliefRay ray, float s_point) {
    float s_end = s_point - self_shadow_bias;
    if (s_end <= 0.0) return 1.0;
#ifdef RELIEFBENCH_CHARTS
    float s_first = enter_chart(ray, s_point);
#elif defined(RELIEFBENCH_BENT_RAY)
    float s_first = enter_relief_bent(ray, s_point);
#else
    float s_first = enter_relief(ray, s_point);
#endif
#ifdef RELIEFBENCH_OWN_MARCH
    // A technique's search knows only rays that enter from above.
    if (s_first <= 0.0) {
        Trace found = checked_trace(ray);
        if (found.kind == trace_miss || !found.converged) return 1.0;
        float s_found = found.kind == trace_on_ray ? found.s : s_at_height(ray, found.h);
        return s_found < s_end ? 0.0 : 1.0;
    }
#endif
    return march_to_point(ray, s_first, s_point, s_end) ? 0.0 : 1.0;
}

#ifdef RELIEFBENCH_BENT_RAY
// Of a light whose bent ray comes down again before it reaches h = 1, over a hollow base: it enters through the floor's back,
// which is transparent, and is marched in uniform layers from there to the point.
float hollow_visibility(ReliefRay ray, vec2 uv, float h) {
    float bend = bend_of(ray.straight_offset);
    vec2 uv_bend = uv_bend_of(ray.straight_offset);
    vec2 offset = ray.straight_offset + (1.0 - h) * uv_bend;
    // Where h + r + bend r^2 is 0.
    float farthest = (1.0 + sqrt(1.0 - 4.0 * bend * h)) / (-2.0 * bend);
    int layers = max(1, int(shadow_layers(ray.to_eye)));
    bool above = false;
    for (int i = 0; i < layers; ++i) {
        float r = farthest * (1.0 - float(i) / float(layers));
        if (r <= self_shadow_bias) break;
        vec2 place = uv - r * (offset - r * uv_bend);
        bool beneath = !casts_shadow(place) || tap_height(place) > h + r * (1.0 + bend * r);
        if (above && beneath && casts_shadow(place)) return 0.0;
        above = !beneath;
    }
    return 1.0;
}
#endif

// Dykhta 2013: from the point, lifted by the bias, towards the light in layers. What lies beneath the surface counts by
// its depth under it, and the less the farther away it is; the most of it is the shadow.
float dykhta_visibility(ReliefRay ray, vec2 uv, float s_point) {
    float s_start = s_point - self_shadow_bias;
    if (s_start <= 0.0) return 1.0;
    float layers = shadow_layers(ray.to_eye);
    float shadow = 0.0;
    for (float i = 1.0; i < layers; ++i) {
        float risen = s_start * i / layers;
        vec2 place = uv - risen * straight_offset(ray);
        if (!casts_shadow(place)) break;
        float beneath = (s_start - risen) - (1.0 - tap_height(place));
        shadow = max(shadow, beneath * (1.0 - i / layers));
    }
    return pow(1.0 - shadow, dykhta_contrast);
}

// Tatarchuk 2006, as in the DirectX SDK's sample: the highest of a few heights above the light's way, which rises by 1
// within the light's own offset, not divided by its z.
float tatarchuk_visibility(ReliefRay ray, vec2 uv, float h) {
#ifdef RELIEFBENCH_CURVED
    vec2 full_offset = ray.height_scale * ray.uv_per_length * ray.to_eye.xy;
#else
    vec2 full_offset = scene.tiling * scene.height_scale * ray.to_eye.xy;
#endif
    float shadow = 0.0;
    for (int i = 0; i < tatarchuk_taps; ++i) {
        vec2 blocker = uv + tatarchuk_distances[i] * full_offset;
        if (!casts_shadow(blocker)) continue;
        float above = tap_height(blocker) - h - tatarchuk_distances[i];
        shadow = max(shadow, above * tatarchuk_weights[i] * self_shadow_softening);
    }
    return clamp(mix(tatarchuk_least, 1.0, 1.0 - shadow), 0.0, 1.0);
}

// Of the light from `to_light` at the surface over texture coordinates `uv`, whose height is `h`. The light's ray has the
// footprint of `view_ray`.
float visibility_of_light(vec3 to_light, vec2 uv, float h, ReliefRay view_ray) {
#ifdef RELIEFBENCH_CURVED
    // In the frame of the pixel's entry, as engines have it.
    if (dot(to_light, curved_entry.frame[2]) <= 0.0 || way_over_base(to_light).z <= 0.0) return 0.0;
    vec2 max_offset = curved_offset(to_light);
    float s_point = 1.0 - h;
    ReliefRay ray = curved_ray(uv - s_point * max_offset, max_offset, to_light, view_ray.uv_dx, view_ray.uv_dy,
                               view_ray.level);
#else
    // The ground that the relief is sunk into is opaque.
    if (to_light.z <= 0.0) return 0.0;
    float height = scene.tiling * scene.height_scale;
    vec2 max_offset = -height * to_light.xy / to_light.z;
    float s_point = 1.0 - h;
    ReliefRay ray = plane_ray(uv - s_point * max_offset, max_offset, to_light, view_ray.uv_dx, view_ray.uv_dy,
                              view_ray.level);
#endif
#if defined(RELIEFBENCH_BENT_RAY) && defined(RELIEFBENCH_CURVED)
    if (self_shadow == self_shadow_hard && !turned_offset(to_light, uv, ray.straight_offset)) return 0.0;
#endif
#ifdef RELIEFBENCH_BENT_RAY
    // The published soft ones know straight rays.
    if (self_shadow == self_shadow_hard && !bend_light_ray(ray, uv, h, s_point)) return hollow_visibility(ray, uv, h);
#endif
    if (self_shadow == self_shadow_hard) return hard_visibility(ray, s_point);
    if (self_shadow == self_shadow_dykhta) return dykhta_visibility(ray, uv, s_point);
    return tatarchuk_visibility(ray, uv, h);
}

// By light, at the surface over patch coordinates: where a technique's answer lies beside the surface, its shadow is
// that of the surface there, as its colour and normal are. The light's rays have the footprint of `view_ray`.
vec3 light_visibility(vec2 patch_uv, ReliefRay view_ray) {
    vec3 visibility = vec3(1.0);
    if (self_shadow == self_shadow_off || !lighting_enabled) return visibility;
    vec2 uv = scene.tiling * patch_uv;
    float h = tap_height(uv);
    for (int i = 0; i < scene.light_count; ++i)
        visibility[i] = visibility_of_light(scene.light_direction[i].xyz, uv, h, view_ray);
    return visibility;
}

#endif
