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

// With height_lod another surface is searched than the one at level 0, which the truth has.
float tap_along(ReliefRay ray, float s) {
    vec2 uv = point_on_ray(ray, s);
    if (height_lod == height_lod_entry) return tap_map(height_mips, uv, ray.level).r;
    if (height_lod == height_lod_gradients) return tap_map_gradients(height_mips, uv, ray.uv_dx, ray.uv_dy).r;
    return height_filter == height_filter_exact ? tap_height_exactly(uv) : tap_height(uv);
}

// Luna 2012, section 5: from max_steps at grazing view to min_steps head-on, by N·V or what adaptive_by says.
float unrounded_layers(ReliefRay ray) {
    const float grazing_angle = 1.5707963;
    float most = float(max_steps);
    float least = float(min_steps);
    if (adaptive_by == adaptive_by_angle) return mix(least, most, acos(min(ray.to_eye.z, 1.0)) / grazing_angle);
    if (adaptive_by == adaptive_by_texels) {
#ifdef RELIEFBENCH_BENT_RAY
        float texels = length((point_on_ray(ray, ray.s_end) - ray.uv) * vec2(height_map_size()));
#else
        float texels = length(straight_offset(ray) * vec2(height_map_size()));
#endif
        return max(least, min(most, layers_per_texel * texels));
    }
    return mix(most, least, ray.to_eye.z);
}

// At least 1. A whole number, cut off as published, unless step_rounding says otherwise.
float layer_count(ReliefRay ray) {
    if (!adaptive) return float(max_steps);
    float layers = max(1.0, unrounded_layers(ray));
    return step_rounding == step_rounding_fractional ? layers : floor(layers);
}

// Where the ray first passes beneath the surface, between two neighbouring layers. The last layer lies at the ray's end,
// at h = 0, where every ray is at or beneath the surface: a crossing is always found, but by bent rays that end at h = 1.
// Of a fractional number of layers the last is thinner, and comes and goes without a jump.
Crossing find_crossing(ReliefRay ray, float layers) {
    float h = tap_along(ray, 0.0);
    if (enters_surface(h)) h = 1.0;
    Crossing crossing = Crossing(0.0, h, 0.0, h, 0);
#ifdef RELIEFBENCH_START_OFFSET
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
    if (refinement == refinement_secant) return refine_by_secants(ray, crossing, secant_steps);
    if (refinement == refinement_binary) return refine_by_halving(ray, crossing, binary_steps);
    if (refinement == refinement_contact) {
        int finer_steps = refinement_steps > 0 ? refinement_steps : int(ceil(layers));
        return refine_by_marching_again(ray, crossing, refinements, finer_steps);
    }
    return Refined(crossing.s_below, crossing.steps);
}
