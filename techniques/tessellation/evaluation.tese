#include "patches.glsl"
#ifndef RELIEFBENCH_CURVED
#include "grid_shift.glsl"
#endif

#ifdef SPACING_FRACTIONAL_EVEN
#define SPACING fractional_even_spacing
#elif defined(SPACING_FRACTIONAL_ODD)
#define SPACING fractional_odd_spacing
#else
#define SPACING equal_spacing
#endif
#if defined(DOMAIN_TRIANGLES) || defined(RELIEFBENCH_CURVED)
layout(triangles, SPACING, ccw) in;
#else
layout(quads, SPACING, ccw) in;
#endif

#ifdef RELIEFBENCH_CURVED
void main() {
    vec2 patch_uv = grid_coordinates();
    emit_surface(patch_uv, tap_height(scene.tiling * patch_uv));
}
#else
// The border of the patch stays where it is.
vec2 on_texel_centres(vec2 grid) {
    vec2 shifted = grid + texel_centre_shift();
    if (relief_repeats) return shifted;
    return mix(min(shifted, 1.0), grid, lessThanEqual(grid * (1.0 - grid), vec2(0.0)));
}

void main() {
    vec2 patch_uv = on_texel_centres(grid_coordinates());
    emit_surface(patch_uv, tap_height(scene.tiling * patch_uv));
}
#endif
