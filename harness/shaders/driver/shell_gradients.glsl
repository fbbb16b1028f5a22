#ifndef RELIEFBENCH_SHELL_GRADIENTS_GLSL
#define RELIEFBENCH_SHELL_GRADIENTS_GLSL

// The same of a shell, whose rays may come from any side: on facets of the base or of the relief.

#include "base_mesh.glsl"
#include "material_gradients.glsl"
#include "pixel_step.glsl"

// Texture coordinates of a step beside the ray, taken along it into the facet that dS/du and dS/dv span. `handedness`: of these
// and the facet's upper side.
vec2 way_on_facet(vec3 along_u, vec3 along_v, float handedness, vec3 step_aside, vec3 direction) {
    vec3 across = cross(along_u, along_v);
    float facing = max(-handedness * dot(direction, across), length(across) / max_stretch);
    vec3 way = step_aside + direction * (handedness * dot(step_aside, across) / facing);
    return scene.tiling * vec2(dot(cross(way, along_v), across), dot(cross(along_u, way), across)) /
           dot(across, across);
}

// On the base's triangle, as far away as the ray's point at distance t.
vec2 base_gradient_x(BaseTriangle triangle, ViewRay view, float t) {
    return way_on_facet(triangle.along_u, triangle.along_v, triangle.handedness, pixel_step_x(view, t), view.direction);
}
vec2 base_gradient_y(BaseTriangle triangle, ViewRay view, float t) {
    return way_on_facet(triangle.along_u, triangle.along_v, triangle.handedness, pixel_step_y(view, t), view.direction);
}

#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
// The corner opposite to the face by which a ray enters the tetrahedron, by barycentric coordinates along it.
int entered_opposite_to(vec4 weights, vec4 per_length) {
    int entered = -1;
    float first = 0.0;
    for (int i = 0; i < 4; ++i) {
        if (!(per_length[i] > 0.0)) continue;
        float t = -weights[i] / per_length[i];
        if (entered >= 0 && t <= first) continue;
        entered = i;
        first = t;
    }
    return entered;
}
#endif

#ifdef RELIEFBENCH_GRADIENTS_ANALYTIC
// dS/du and dS/dv at height h, where the relief's offset along N changes by `slope` with u and v.
void displaced_tangents(BaseTriangle triangle, vec2 uv, float h, vec2 slope, out vec3 along_u, out vec3 along_v) {
    vec3 linear = linear_normal(triangle, uv);
    vec3 normal = normalize(linear);
    float above = (h - 1.0) * scene.height_scale / length(linear);
    along_u = triangle.along_u + slope.x * normal +
              above * (triangle.normal_along_u - normal * dot(normal, triangle.normal_along_u));
    along_v = triangle.along_v + slope.y * normal +
              above * (triangle.normal_along_v - normal * dot(normal, triangle.normal_along_v));
}

// On the relief over it.
void take_gradients_of_relief(BaseTriangle triangle, ViewRay view, vec2 slope, vec4 hit) {
    vec3 along_u;
    vec3 along_v;
    displaced_tangents(triangle, hit.xy, hit.z, slope, along_u, along_v);
    material_dx = way_on_facet(along_u, along_v, triangle.handedness, pixel_step_x(view, hit.w), view.direction);
    material_dy = way_on_facet(along_u, along_v, triangle.handedness, pixel_step_y(view, hit.w), view.direction);
}
#endif

#endif
