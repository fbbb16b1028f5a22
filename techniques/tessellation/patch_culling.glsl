// Which patches can be left out: bounds of what their vertices can become, never what they are, so that nothing that
// could be seen goes missing.

#include "slope_bounds.glsl"

// A patch in patch coordinates, over heights from 0 to 1.
struct PatchBounds {
    vec2 low;
    vec2 high;
};

// `shift`: how far vertices move from their places.
PatchBounds patch_bounds(vec2 shift) {
    PatchBounds bounds = PatchBounds(vertex_corner[0], vertex_corner[0]);
    for (int i = 1; i < patch_corners; ++i) {
        bounds.low = min(bounds.low, vertex_corner[i]);
        bounds.high = max(bounds.high, vertex_corner[i]);
    }
    bounds.high += shift;
    return bounds;
}

// In clip coordinates: rounding, and what a rasteriser's snapping of vertices moves.
const float frustum_margin = 0.01;

bool is_outside_frustum(PatchBounds bounds) {
    // Of the box's corner that lies farthest inside each of the frustum's planes.
    vec3 inside_low = vec3(-1e30);
    vec3 inside_high = vec3(-1e30);
    for (int corner = 0; corner < 8; ++corner) {
        vec2 uv = mix(bounds.low, bounds.high, vec2(corner & 1, (corner >> 1) & 1));
        vec4 clip = scene.clip_from_world * vec4(surface_point(uv, float(corner >> 2)), 1.0);
        inside_low = max(inside_low, vec3(clip.xy + clip.w, clip.z));
        inside_high = max(inside_high, vec3(clip.w) - clip.xyz);
    }
    return any(lessThan(min(inside_low, inside_high), vec3(-frustum_margin)));
}

// Bounds of the slopes of all cells that the patch touches, as slope_bounds.glsl has them.
vec4 slopes_within(PatchBounds bounds) {
    ivec2 size = height_map_size();
    vec2 texels = scene.tiling * vec2(size);
    ivec2 first = ivec2(floor(bounds.low * texels - 0.5));
    ivec2 last = min(ivec2(floor(bounds.high * texels - 0.5)), first + size - 1);
    ivec2 extent = last - first + 1;
    // Two to six nodes on a side: few, and yet not much larger together than the patch.
    int tree_level = clamp(findMSB(max(extent.x, extent.y)) - 1, 0, textureQueryLevels(slopes) - 1);
    vec4 rises = no_slopes;
    ivec2 cell;
    ivec2 next;
    for (cell.y = first.y; cell.y <= last.y; cell.y = next.y) {
        for (cell.x = first.x; cell.x <= last.x; cell.x = next.x) {
            ivec2 wrapped = ((cell % size) + size) % size;
            ivec2 node = wrapped >> tree_level;
            next = cell + min((node + 1) << tree_level, size) - wrapped;
            rises = join_slopes(rises, decode_slopes(tap_map_texel(slopes, node, tree_level)));
        }
    }
    return rises;
}

// How much steeper than the surface's slopes a triangle between points of it can be, for each difference of slopes. A
// triangle that has sides along u and along v has slopes that the surface has between its corners. Of another one, with a
// side e1 and another one e2, the slope along d differs from them by at most |e2|/w of the difference, w the distance of
// e2's end from e1. Where the factor varies, triangles at the border of a patch reach over all of it, and w is a segment
// (in a triangle, two thirds of one along the shortest height). In one cut evenly they are halves of even pieces.
float stretch() {
    const float of_even_triangles = 3.5;
    const float of_uneven_strips = 3.0;
    if (factor_by != factor_by_fixed) return of_uneven_strips * float(max(factor, min_factor));
    return patch_corners == 3 ? of_even_triangles : 0.0;
}

// Cosine under which a triangle is nearly edge-on: a rasteriser's snapping may turn it.
const float facing_margin = 0.05;

bool shows_its_back_only(PatchBounds bounds) {
    // Growing segments can be as short as nothing, and triangles on them as steep as anything, unless all sides of a quad
    // are cut alike.
    bool may_have_slivers = spacing != spacing_equal && (patch_corners == 3 || factor_by != factor_by_fixed);
    if (may_have_slivers) return false;

    vec4 rises = slopes_within(bounds);
    vec2 slope_per_rise = scene.height_scale * scene.tiling * vec2(height_map_size());
    vec2 least = rises.xz * slope_per_rise;
    vec2 most = rises.yw * slope_per_rise;

    // Bounds of the vector from a point of the patch to the eye.
    vec3 least_to_eye = -scene.forward;
    vec3 most_to_eye = -scene.forward;
    if (scene.parallel_rays == 0) {
        least_to_eye = scene.eye - surface_point(bounds.high, 1.0);
        most_to_eye = scene.eye - surface_point(bounds.low, 0.0);
    }
    // The surface shows its front where slope · to_eye.xy < to_eye.z.
    vec2 against = min(min(least * least_to_eye.xy, least * most_to_eye.xy),
                       min(most * least_to_eye.xy, most * most_to_eye.xy));
    vec2 to_eye = max(abs(least_to_eye.xy), abs(most_to_eye.xy));
    vec2 extent = bounds.high - bounds.low;
    float steeper = stretch() * length(to_eye / extent) * length((most - least) * extent);
    float front = most_to_eye.z - (against.x + against.y) + steeper;
    float margin = facing_margin * length(vec3(to_eye, most_to_eye.z)) * length(vec3(max(abs(least), abs(most)), 1.0));
    return front < -margin;
}

bool may_be_seen(vec2 shift) {
    PatchBounds bounds = patch_bounds(shift);
    return !is_outside_frustum(bounds) && !shows_its_back_only(bounds);
}
