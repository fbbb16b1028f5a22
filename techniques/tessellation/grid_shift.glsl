// Vertices inside the patch move by this, the fraction of a segment that puts them on texel centres, where the bilinear
// surface has its corners, whenever segments and texels go evenly into each other. Where the factor varies they do not.
vec2 texel_centre_shift() {
    if (factor_by != factor_by_fixed) return vec2(0.0);
    vec2 segments = vec2(scene.patches_per_side * factor);
    vec2 texels = scene.tiling * vec2(height_map_size());
    return fract(0.5 * segments / texels) / segments;
}
