#include "patches.glsl"
#include "grid_shift.glsl"
#include "patch_culling.glsl"

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

void main() {
    pass_corner();
    if (gl_InvocationID != 0) return;
    set_factors();
    count_stage();
}
