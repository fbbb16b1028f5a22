#include "patches.glsl"
#ifndef RELIEFBENCH_CURVED
#include "grid_shift.glsl"
#include "patch_culling.glsl"
#endif

#ifdef RELIEFBENCH_CURVED
// A patch is what triangle the base has there, large or small: `factor` is that of a side of so many texels, as many as a
// patch of the plane has by default.
const float texels_of_factor = 64.0;

// From the ends of a side alone, and the same whichever comes first, with distances and pixels of the curved base.
float side_factor(int a, int b) {
    vec2 texels = scene.tiling * vec2(height_map_size()) * (vertex_corner[a] - vertex_corner[b]);
    precise float most = clamp(float(factor) * length(texels) / texels_of_factor, 1.0, 64.0);
    if (factor_by == factor_by_fixed) return most;
    precise vec3 middle = 0.5 * (vertex_position[a] + vertex_position[b]);
    precise float wanted;
    if (factor_by == factor_by_distance) {
        float far = (distance(scene.eye, middle) - near_distance) / max(far_distance - near_distance, 1e-6);
        wanted = mix(most, float(min_factor), clamp(far, 0.0, 1.0));
    } else {
        wanted = pixels_across(middle, distance(vertex_position[a], vertex_position[b])) / segment_pixels;
    }
    return clamp(wanted, float(min_factor), max(most, float(min_factor)));
}

void set_factors() { set_side_factors(vec3(side_factor(1, 2), side_factor(2, 0), side_factor(0, 1))); }
#else
// From the ends of a side alone, and the same whichever comes first: both patches at the side get the same factor, bit
// for bit, and no crack opens between them.
float side_factor(vec2 a, vec2 b) {
    if (factor_by == factor_by_fixed) return float(factor);
    vec3 middle = surface_point(0.5 * (a + b), 1.0);
    precise float wanted;
    if (factor_by == factor_by_distance) {
        // Luna: falling evenly from the near to the far distance.
        float far = (distance(scene.eye, middle) - near_distance) / max(far_distance - near_distance, 1e-6);
        wanted = mix(float(factor), float(min_factor), clamp(far, 0.0, 1.0));
    } else {
        // Cantlay: of the sphere around the side, so that a side that is seen end-on does not lose its segments.
        wanted = pixels_across(middle, distance(a, b)) / segment_pixels;
    }
    return clamp(wanted, float(min_factor), float(max(factor, min_factor)));
}

void set_factors() {
    if (cull && !may_be_seen(texel_centre_shift())) {
        drop_patch();
        return;
    }
#ifdef DOMAIN_TRIANGLES
    set_side_factors(vec3(side_factor(vertex_corner[1], vertex_corner[2]), side_factor(vertex_corner[2], vertex_corner[0]),
                          side_factor(vertex_corner[0], vertex_corner[1])));
#else
    set_side_factors(vec4(side_factor(vertex_corner[0], vertex_corner[2]), side_factor(vertex_corner[0], vertex_corner[1]),
                          side_factor(vertex_corner[1], vertex_corner[3]), side_factor(vertex_corner[2], vertex_corner[3])));
#endif
}
#endif

void main() {
    pass_corner();
    if (gl_InvocationID != 0) return;
    set_factors();
    count_stage();
}
