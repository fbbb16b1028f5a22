#include "patches.glsl"

layout(quads, equal_spacing, ccw) in;

// Inner vertices move by the fraction of a quad that puts them on texel centres, where the bilinear surface has its
// corners, whenever quads and texels go evenly into each other; the border of the patch stays where it is.
vec2 on_texel_centres(vec2 grid) {
    vec2 quads = vec2(scene.patches_per_side * factor);
    vec2 texels = scene.tiling * vec2(height_map_size());
    vec2 shifted = grid + fract(0.5 * quads / texels) / quads;
    if (relief_repeats) return shifted;
    return mix(min(shifted, 1.0), grid, lessThanEqual(grid * (1.0 - grid), vec2(0.0)));
}

void main() {
    vec2 patch_uv = on_texel_centres(grid_coordinates());
    emit_surface(patch_uv, tap_height(scene.tiling * patch_uv));
}
