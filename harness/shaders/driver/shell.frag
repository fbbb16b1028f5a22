// A technique of the shell: its trace_shell() in one tetrahedron; what it finds is nearest by its depth.

#include "answer_range.glsl"
#include "scene.glsl"
#ifdef RELIEFBENCH_MATERIAL_MIPS
#include "shell_gradients.glsl"
#endif
#include "shell_prism.glsl"
#include "shell_ray.glsl"
#include "surface.glsl"
#include "work.glsl"
#include "trace.glsl"

layout(location = 0) flat in int tetrahedron_index;
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
layout(location = 1) flat in int opposite_corner;  // to the face that is drawn
#endif

// What is hidden behind relief that has been found need not be searched: nothing lies before the face that is drawn.
layout(depth_greater) out float gl_FragDepth;

Trace trace_shell(ShellRay ray);

// By which a piece goes on past the tetrahedron's faces: what single precision loses of places, as a fraction of the
// coordinates that they come from.
const float relative_overlap = 5e-7;

// Beyond any.
const float no_distance = 1e30;

#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
// Whether this fragment's ray crosses the tetrahedron, and whether its answer counts for its neighbours: not where the ray
// enters by another face, as beside the one that is drawn some devices read no buffer, and others run all of the shader.
bool searches = false;
bool takes_part = false;
#endif

// Within a tetrahedron, distances from `start`.
struct Crossed {
    float first;
    float last;
    bool from_base;
};

// In barycentric coordinates, which change linearly along the ray: inside, none of them is negative.
Crossed cross_tetrahedron(Tetrahedron tetrahedron, vec4 weights, vec4 per_length) {
    Crossed crossed = Crossed(-no_distance, no_distance, false);
    for (int i = 0; i < 4; ++i) {
        if (per_length[i] == 0.0) continue;
        float t = -weights[i] / per_length[i];
        if (per_length[i] < 0.0) {
            crossed.last = min(crossed.last, t);
        } else if (t > crossed.first) {
            crossed.first = t;
            // The face opposite to corner 3 of the first tetrahedron is the base's.
            crossed.from_base = i == 3 && tetrahedron.corners[2].place.z == 1.0;
        }
    }
    return crossed;
}

// The piece of the ray from `start` on, where the corners' weights are `weights`; it goes on past both ends by `overlap`.
void draw_piece(ViewRay view, vec4 weights, vec4 per_length, float t_start, Crossed crossed, float overlap,
                Tetrahedron tetrahedron) {
    float first = crossed.first - overlap;
    float length_inside = crossed.last + overlap - first;

    mat4x3 places = mat4x3(tetrahedron.corners[0].place, tetrahedron.corners[1].place, tetrahedron.corners[2].place,
                           tetrahedron.corners[3].place);
    vec3 to_texture = vec3(scene.tiling, scene.tiling, 1.0);
    ShellRay ray = ShellRay(to_texture * (places * (weights + first * per_length)),
                            to_texture * (places * (length_inside * per_length)), crossed.from_base);
#ifdef RELIEFBENCH_PROBED
    count_begin(scene.resolution, gl_FragCoord.xy);
#endif
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
    Trace found = miss(0);
    if (searches) found = trace_shell(ray);
#else
    Trace found = trace_shell(ray);
#endif
#ifdef RELIEFBENCH_PROBED
    // An answer beside the ray has no s, which is not a number then.
    uint bits = found.kind == trace_off_ray ? 0x7fc00000u : floatBitsToUint(found.s);
    bool has_s = found.kind != trace_off_ray && answer_is_in_unit_range(found.s);
    uint fault = found.kind == trace_miss || has_s ? answer_fault_none : answer_fault_s;
    if (fault == answer_fault_none) fault = answer_fault_of_steps(found.steps, bits);
    if (fault != answer_fault_none) count_fault(scene.resolution, gl_FragCoord.xy, fault, bits);
#endif
    count_pixel(scene.resolution, gl_FragCoord.xy, found.steps, found.converged);
#ifdef RELIEFBENCH_MATERIAL_MIPS
    BaseTriangle below = base_triangle(tetrahedron_index / tetrahedra_per_prism);
    material_dx = base_gradient_x(below, view, t_start + first);
    material_dy = base_gradient_y(below, view, t_start + first);
#endif
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
    // Before any of the quad is discarded. What misses this tetrahedron's relief may hit the next one's.
    takes_part = takes_part && found.kind != trace_miss;
    take_gradients_of_answers(point_on_ray(ray, found.s), takes_part, material_dx, material_dy);
#endif
    if (found.kind == trace_miss) discard;

    float t = t_start + first + found.s * length_inside;
    vec4 hit = vec4(point_on_ray(ray, found.s) / scene.tiling, clamp(height_of_ray(ray, found.s), 0.0, 1.0), max(0.0, t));
    vec4 clip = scene.clip_from_world * vec4(view.origin + t * view.direction, 1.0);
    gl_FragDepth = max(clip.z / clip.w, gl_FragCoord.z);
    BaseTriangle triangle = base_triangle(tetrahedron_index / tetrahedra_per_prism);
#ifdef RELIEFBENCH_GRADIENTS_ANALYTIC
    vec2 slope = vec2(0.0);
    if (!found.flat_normal)
        slope = scene.tiling * slope_over_footprint(scene.tiling * hit.xy, material_dx, material_dy);
    take_gradients_of_relief(triangle, view, slope, hit);
#endif
    vec3 normal = found.flat_normal ? normalize(linear_normal(triangle, hit.xy))
                                    : displaced_normal(triangle, hit.xy, hit.z, surface_slope(hit.xy));
    write_surface(hit, view.direction, normal, vec3(1.0));
}

void main() {
    ViewRay view = view_ray(gl_FragCoord.xy);
    Tetrahedron tetrahedron = shell_tetrahedron(tetrahedron_index);
    vec3 corner = tetrahedron.corners[0].position;
    mat3 to_weights = inverse(mat3(tetrahedron.corners[1].position - corner, tetrahedron.corners[2].position - corner,
                                   tetrahedron.corners[3].position - corner));
    // From near the tetrahedron, so that little is lost to the eye's distance.
    float t_start = dot(corner - view.origin, view.direction);
    vec3 inner = to_weights * (view.origin + t_start * view.direction - corner);
    vec3 inner_per_length = to_weights * view.direction;
    vec4 weights = vec4(1.0 - inner.x - inner.y - inner.z, inner);
    vec4 per_length = vec4(-inner_per_length.x - inner_per_length.y - inner_per_length.z, inner_per_length);
    Crossed crossed = cross_tetrahedron(tetrahedron, weights, per_length);
    float overlap = relative_overlap * (length(view.origin) + length(corner));
    // The rasteriser may draw what the ray passes by; and a device may run a fragment's neighbours with it, for which no
    // buffer is read: their weights are no numbers, and set neither end.
    bool is_crossed = crossed.first > -no_distance && crossed.first <= crossed.last + 2.0 * overlap;
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
    // All of the quad go on to where answers are compared.
    searches = is_crossed;
    takes_part = searches && entered_opposite_to(weights, per_length) == opposite_corner;
    draw_piece(view, weights, per_length, t_start, crossed, overlap, tetrahedron);
#else
    if (is_crossed) {
        draw_piece(view, weights, per_length, t_start, crossed, overlap, tetrahedron);
    } else {
        count_pixel(scene.resolution, gl_FragCoord.xy, 0, true);
        discard;
    }
#endif
}
