#ifndef RELIEFBENCH_CONE_PREPARATION_GLSL
#define RELIEFBENCH_CONE_PREPARATION_GLSL

// Passes that search the height map for cones. The cone of a texel stands with its apex on the surface over the texel's
// centre and opens upward; its ratio is its radius over its height, the radius in texture coordinates and the height in
// units of the height scale. The wider it is, the further a ray may go within it. Searches keep the square of the ratio,
// and square distances, which spares a root for each texel searched.

// No cone is wider than this (Dummer 2006): ratios then fit a texture of [0, 1].
const float widest_cone = 1.0;

// The square of the ratio at which a cone with its apex at height `apex` meets a point at height h, at a distance of which
// this is the square; the widest where the point is no higher.
float square_ratio_to(float square_distance, float h, float apex) {
    float rise = h - apex;
    return rise > 0.0 ? min(square_distance / (rise * rise), widest_cone * widest_cone) : widest_cone * widest_cone;
}

// From this distance on, squared, no point narrows the cone any more: its rim is at h = 1.
float square_reach_of(float square_ratio, float apex) { return square_ratio * (1.0 - apex) * (1.0 - apex); }

#endif
