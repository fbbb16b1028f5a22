#ifndef RELIEFBENCH_CURVED_RAY_GLSL
#define RELIEFBENCH_CURVED_RAY_GLSL

// Rays over a base that is not flat. A pixel's ray meets the triangle here, not by what the rasteriser interpolates, whose
// snapping would show in the errors. Of the base a ray knows what engines know: the tangent frame where the pixel enters, and
// where it is bent (relief_ray.glsl) how the normals of the triangle turn.

#include "base_charts.glsl"
#include "base_mesh.glsl"
#include "relief.glsl"
#include "scene.glsl"
#ifdef RELIEFBENCH_BENT_RAY
#include "bent_ray.glsl"
#include "hand_curvature.glsl"
#endif

// Where the pixel's ray passes the base.
struct CurvedEntry {
    vec2 uv;  // patch coordinates
    vec3 point;
    vec3 along_u;  // dP/du
    vec3 along_v;
    mat3 frame;          // orthonormal: tangent, bitangent, N
    mat2 uv_per_length;  // patch coordinates for each unit of length along tangent and bitangent
    vec3 per_normal;     // a direction times this: how often it has N beside dP/du and dP/dv
    float handedness;    // of (dP/du, dP/dv, N)
    vec2 uv_dx;          // how `uv` changes from pixel to pixel, on this triangle
    vec2 uv_dy;
    uint chart;
#ifdef RELIEFBENCH_BENT_RAY
    mat2 fall;   // second fundamental form of (u, v), from the triangle's normals: positive where the base falls away
    mat2 shape;  // shape operator of (u, v): the same as a map of tangent vectors
#endif
};

// Of this fragment.
CurvedEntry curved_entry;

// A direction of the world as multiples of dP/du, dP/dv and N: what a ray travels in u, in v and upwards over its length.
// Upwards is not the cosine to N: the facet, in which dP/du and dP/dv lie, is tilted against it.
vec3 way_over_base(vec3 direction) {
    return vec3(curved_entry.uv_per_length * (direction * curved_entry.frame).xy,
                dot(direction, curved_entry.per_normal));
}

#include "pixel_step.glsl"

// Along the ray back into the triangle's plane.
vec3 slid_onto(vec3 step, vec3 direction, vec3 facet_normal) {
    return step - direction * (dot(step, facet_normal) / dot(direction, facet_normal));
}

// Lets the ray pass the triangle, and tells whether it comes from the side of N.
bool enter_base(inout ViewRay view, int index) {
    BaseTriangle triangle = base_triangle(index);
    vec3 from_corner = view.origin - triangle.corner;
    float t = -dot(from_corner, triangle.facet_normal) / dot(view.direction, triangle.facet_normal);
    vec3 inside = from_corner + t * view.direction;
    curved_entry.uv = triangle.corner_uv + way_in_chart(triangle, inside);
    curved_entry.point = triangle.corner + inside;
    curved_entry.along_u = triangle.along_u;
    curved_entry.along_v = triangle.along_v;
    curved_entry.handedness = triangle.handedness;
    curved_entry.chart = base_triangle_charts.at[index];

    vec3 normal = normalize(linear_normal(triangle, curved_entry.uv));
    vec3 tangent = normalize(triangle.along_u - normal * dot(normal, triangle.along_u));
    vec3 bitangent = triangle.handedness * cross(normal, tangent);
    curved_entry.frame = mat3(tangent, bitangent, normal);
    curved_entry.uv_per_length = inverse(
        mat2((triangle.along_u * curved_entry.frame).xy, (triangle.along_v * curved_entry.frame).xy));
    curved_entry.per_normal = triangle.facet_normal / dot(triangle.facet_normal, normal);
#ifdef RELIEFBENCH_BENT_RAY
#ifdef RELIEFBENCH_HAND_CURVATURE
    // Along tangent and bitangent, as the rows of this matrix take (u, v) to lengths.
    mat2 lengths = inverse(curved_entry.uv_per_length);
    curved_entry.fall = transpose(lengths) * hand_fall() * lengths;
#else
    float fall_uv =
        0.5 * (dot(triangle.normal_along_u, triangle.along_v) + dot(triangle.normal_along_v, triangle.along_u));
    curved_entry.fall = mat2(dot(triangle.normal_along_u, triangle.along_u), fall_uv, fall_uv,
                             dot(triangle.normal_along_v, triangle.along_v));
#endif
    float metric_uv = dot(triangle.along_u, triangle.along_v);
    curved_entry.shape = inverse(mat2(dot(triangle.along_u, triangle.along_u), metric_uv, metric_uv,
                                      dot(triangle.along_v, triangle.along_v))) *
                         curved_entry.fall;
#endif
    vec3 step_x = slid_onto(pixel_step_x(view, t), view.direction, triangle.facet_normal);
    vec3 step_y = slid_onto(pixel_step_y(view, t), view.direction, triangle.facet_normal);
    curved_entry.uv_dx = way_in_chart(triangle, step_x);
    curved_entry.uv_dy = way_in_chart(triangle, step_y);

    view.entry = curved_entry.uv;
    view.entry_t = t;
    return dot(view.direction, normal) < 0.0 && dot(view.direction, curved_entry.per_normal) < 0.0;
}

// The ray that descends through texture coordinates `uv` on the base, from `to_eye` in the world, in the entry's frame.
// `offset`: texture coordinates travelled from h = 1 to h = 0.
ReliefRay curved_ray(vec2 uv, vec2 offset, vec3 to_eye, vec2 uv_dx, vec2 uv_dy, float level) {
    return ReliefRay(uv, to_eye * curved_entry.frame, 1.0, scene.height_scale,
                     scene.tiling * curved_entry.uv_per_length, offset, uv_dx, uv_dy, level
#ifdef RELIEFBENCH_BENT_RAY
                     , 0.0, vec2(0.0)
#endif
    );
}

#ifdef RELIEFBENCH_BENT_RAY
float bend_of(vec2 offset) {
    vec2 way = offset / scene.tiling;
    return dot(way, curved_entry.fall * way) / (2.0 * scene.height_scale);
}

vec2 uv_bend_of(vec2 offset) {
#ifdef RAY_MODEL_QUADRIC_UV
    return scene.height_scale * (curved_entry.shape * offset);
#else
    return vec2(0.0);
#endif
}
#endif

// Texture coordinates that a ray against this direction travels from h = 1 to h = 0; it must descend.
vec2 curved_offset(vec3 to_eye) {
    vec3 way = way_over_base(to_eye);
    return -scene.tiling * scene.height_scale / way.z * way.xy;
}

// Whether the base goes on over patch coordinates: on the chart by which the pixel has entered.
bool inside_base(vec2 patch_uv) {
#ifdef RELIEFBENCH_CHARTS
    return inside_chart(curved_entry.chart, patch_uv);
#else
    return inside_patch(patch_uv);
#endif
}

bool has_left_base(vec2 patch_uv, vec2 way) {
#ifdef RELIEFBENCH_CHARTS
    return has_left_chart(curved_entry.chart, patch_uv, way);
#else
    return has_left_patch(patch_uv, way);
#endif
}

#ifdef RELIEFBENCH_BENT_RAY
// The same in the frame that has turned with the base, to first order, from the entry to texture coordinates `uv`; below
// the horizon there it has none, and is false.
bool turned_offset(vec3 to_eye, vec2 uv, out vec2 offset) {
    vec3 way = way_over_base(to_eye);
    vec2 from_entry = uv / scene.tiling - curved_entry.uv;
    float rise = way.z + dot(from_entry, curved_entry.fall * way.xy);
    vec2 along = way.xy - way.z * (curved_entry.shape * from_entry);
    offset = -scene.tiling * scene.height_scale / rise * along;
    return rise > 0.0;
}
#endif

// S as the entry knows it, in its tangent plane: off the ray, the distance along the ray is that of this point.
vec3 surface_point(vec2 patch_uv, float h) {
    vec2 way = patch_uv - curved_entry.uv;
    return curved_entry.point + way.x * curved_entry.along_u + way.y * curved_entry.along_v +
           (h - 1.0) * scene.height_scale * curved_entry.frame[2];
}

// Of the relief over patch coordinates, whose offset along N changes by `slope` with u and v: in the frame of the triangle
// that lies there, if that is asked for and the chart goes on, else in the entry's.
vec3 curved_normal(vec2 patch_uv, vec2 slope) {
#ifdef NORMAL_FRAME_HIT
    int index = triangle_over(curved_entry.chart, patch_uv);
    if (index >= 0) return relief_normal(base_triangle(index), patch_uv, slope);
#endif
    vec3 normal = curved_entry.frame[2];
    return normalize(curved_entry.handedness *
                     cross(curved_entry.along_u + slope.x * normal, curved_entry.along_v + slope.y * normal));
}

#endif
