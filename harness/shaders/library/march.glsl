// Linear search in uniform layers and what follows it: the family of marching techniques, whose parameters march.json
// declares.

#include "bilinear_patch.glsl"
#include "crossing.glsl"
#include "refinement.glsl"

#if defined(START_OFFSET_GRADIENT_NOISE) || defined(START_OFFSET_BLUE_NOISE)
#define RELIEFBENCH_START_OFFSET 1
#include "pixel_noise.glsl"

// How far from the entry the pixel's first layer lies, in layers.
float start_offset_of_pixel() {
#ifdef START_OFFSET_BLUE_NOISE
    return blue_noise_of_pixel();
#else
    return gradient_noise_of_pixel();
#endif
}
#endif

// Bilinear height at texture coordinates, from the four texels in one gather.
float tap_height_exactly(vec2 uv) {
    vec2 place = uv * vec2(height_map_size()) - 0.5;
    vec2 cell = floor(place);
    return patch_height(tap_height_cell(ivec2(cell)), place - cell);
}

// Of the pixel's entry into the base from the eye, in sides of the patch; 0 with parallel rays, which have none.
#define RELIEFBENCH_EYE_DISTANCE 1
float eye_distance();

// Of the mip chain, where one level is read for all steps.
float entry_level(ReliefRay ray) {
    if (height_lod_axis == height_lod_axis_greater) return ray.level + height_lod_bias;
    vec2 size = vec2(height_map_size());
    return log2(min(length(ray.uv_dx * size), length(ray.uv_dy * size))) + height_lod_bias;
}

// With height_lod another surface is searched than the one at level 0, which the truth has.
float tap_along(ReliefRay ray, float s) {
    vec2 uv = point_on_ray(ray, s);
    if (height_lod == height_lod_entry) return tap_map(height_mips, uv, entry_level(ray)).r;
    if (height_lod == height_lod_gradients) return tap_map_gradients(height_mips, uv, ray.uv_dx, ray.uv_dy).r;
    return height_filter == height_filter_exact ? tap_height_exactly(uv) : tap_height(uv);
}

// Luna 2012, section 5: from max_steps at grazing view to min_steps head-on, by N·V or what adaptive_by says.
float unrounded_layers(ReliefRay ray) {
    const float grazing_angle = 1.5707963;
    float most = float(max_steps);
    float least = float(min_steps);
    if (adaptive_by == adaptive_by_angle) return mix(least, most, acos(min(ray.to_eye.z, 1.0)) / grazing_angle);
    // In a relief of unit depth, whose coordinates are the texture's: for one that is shallow nearly head-on, whatever
    // the view (Unity HDRP).
    if (adaptive_by == adaptive_by_uv_angle)
        return mix(least, most, atan(length(straight_offset(ray))) / grazing_angle);
    if (adaptive_by == adaptive_by_distance) return max(least, most * (1.0 - eye_distance() / steps_end_distance));
    if (adaptive_by == adaptive_by_texels) {
#ifdef RELIEFBENCH_BENT_RAY
        float texels = length((point_on_ray(ray, ray.s_end) - ray.uv) * vec2(height_map_size()));
#else
        float texels = length(straight_offset(ray) * vec2(height_map_size()));
#endif
        if (texels_of == texels_of_level_read)
            texels /= exp2(max(0.0, height_lod == height_lod_entry ? entry_level(ray) : ray.level));
        return max(least, min(most, layers_per_texel * texels));
    }
    return mix(most, least, ray.to_eye.z);
}

// At least 1. A whole number, cut off as published, unless step_rounding says otherwise.
float layer_count(ReliefRay ray) {
    if (!adaptive) return float(max_steps);
    float layers = max(1.0, unrounded_layers(ray));
    if (step_rounding == step_rounding_multiple_of_4) return 4.0 * ceil(floor(layers + 0.5) / 4.0);
    return step_rounding == step_rounding_fractional ? layers : floor(layers);
}

#ifdef TAP_BATCH_FOUR
// Whether the march goes on. Layers that are not moved are counted, as where the last one lies is a quotient, which
// devices round differently.
bool has_layers_left(ReliefRay ray, Crossing crossing, float layers) {
#ifdef RELIEFBENCH_START_OFFSET
    bool left = crossing.s_below < end_of_ray(ray);
#else
    bool left = float(crossing.steps) < layers;
#endif
    return left && crossing.h_below < height_of_ray(ray, crossing.s_below);
}
#endif

// Where the ray first passes beneath the surface, between two neighbouring layers. The last layer lies at the ray's end,
// at h = 0, where every ray is at or beneath the surface: a crossing is always found, but by bent rays that end at h = 1.
// Of a fractional number of layers the last is thinner, and comes and goes without a jump.
Crossing find_crossing(ReliefRay ray, float layers) {
    float h = tap_along(ray, 0.0);
    if (enters_surface(h)) h = 1.0;
    Crossing crossing = Crossing(0.0, h, 0.0, h, 0);
#ifdef TAP_BATCH_FOUR
#ifdef RELIEFBENCH_START_OFFSET
    float first = start_offset_of_pixel();
#else
    float first = 1.0;
#endif
    while (has_layers_left(ray, crossing, layers)) {
        vec4 along = min((float(crossing.steps) + vec4(0.0, 1.0, 2.0, 3.0) + first) / layers, 1.0) * end_of_ray(ray);
        // None of them depends on what another finds.
        vec4 heights = vec4(tap_along(ray, along.x), tap_along(ray, along.y), tap_along(ray, along.z),
                            tap_along(ray, along.w));
        for (int i = 0; i < 4 && has_layers_left(ray, crossing, layers); ++i) {
            crossing.s_above = crossing.s_below;
            crossing.h_above = crossing.h_below;
            crossing.s_below = along[i];
            crossing.h_below = heights[i];
            crossing.steps += 1;
        }
    }
#elif defined(RELIEFBENCH_START_OFFSET)
    // All layers move together, but the last: one more than else lies at the ray's end.
    float first = start_offset_of_pixel();
    while (crossing.s_below < end_of_ray(ray) && crossing.h_below < height_of_ray(ray, crossing.s_below)) {
        crossing.s_above = crossing.s_below;
        crossing.h_above = crossing.h_below;
        crossing.s_below = min((float(crossing.steps) + first) / layers, 1.0) * end_of_ray(ray);
        crossing.steps += 1;
        crossing.h_below = tap_along(ray, crossing.s_below);
    }
#else
    while (float(crossing.steps) < layers && crossing.h_below < height_of_ray(ray, crossing.s_below)) {
        crossing.steps += 1;
        crossing.s_above = crossing.s_below;
        crossing.h_above = crossing.h_below;
        crossing.s_below = float(crossing.steps) / layers * end_of_ray(ray);
        if (step_rounding == step_rounding_fractional) crossing.s_below = min(crossing.s_below, end_of_ray(ray));
        crossing.h_below = tap_along(ray, crossing.s_below);
    }
#endif
    return crossing;
}

#ifdef RELIEFBENCH_BENT_RAY
// Whether the ray has left the relief again without a crossing.
bool has_missed(ReliefRay ray, Crossing crossing) { return leaves_above(ray) && gap_below(ray, crossing) < 0.0; }
#endif

Refined refine(ReliefRay ray, Crossing crossing, float layers) {
    if (refinement == refinement_linear) return refine_linearly(ray, crossing);
    if (refinement == refinement_secant) return refine_by_secants(ray, crossing, secant_steps, secant_tolerance);
    if (refinement == refinement_binary) return refine_by_halving(ray, crossing, binary_steps);
    if (refinement == refinement_contact) {
        int finer_steps = refinement_steps > 0 ? refinement_steps : int(ceil(layers));
        return refine_by_marching_again(ray, crossing, refinements, finer_steps);
    }
    return Refined(crossing.s_below, crossing.steps);
}
