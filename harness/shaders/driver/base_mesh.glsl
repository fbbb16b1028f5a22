#ifndef RELIEFBENCH_BASE_MESH_GLSL
#define RELIEFBENCH_BASE_MESH_GLSL

// The triangles of a base that is not flat: the mirror of harness/scene/surface/base_mesh.hpp.

#include "scene.glsl"

struct BaseVertex {
    vec3 position;
    float u;
    vec3 normal;
    float v;
};

layout(set = 0, binding = 6, std430) readonly buffer BaseVertices { BaseVertex at[]; }
base_vertices;
layout(set = 0, binding = 7, std430) readonly buffer BaseIndices { uint at[]; }
base_indices;

// The mirror of ChartGrid in harness/scene/surface/chart_grid.hpp, with the charts' periods.
struct BaseChart {
    vec2 low;
    vec2 cells_per_uv;
    uvec2 cells;
    uint first_cell;
    uint unused;
    vec2 period;  // 0 where it does not meet itself
};

// Numbers beyond those of derived maps.
layout(set = 0, binding = 60, std430) readonly buffer BaseCharts { BaseChart at[]; }
base_charts;
layout(set = 0, binding = 61, std430) readonly buffer BaseTriangleCharts { uint at[]; }
base_triangle_charts;
layout(set = 0, binding = 62, std430) readonly buffer BaseCellStarts { uint at[]; }
base_cell_starts;
layout(set = 0, binding = 63, std430) readonly buffer BaseCellTriangles { uint at[]; }
base_cell_triangles;

BaseVertex base_vertex(int triangle, int corner) {
    return base_vertices.at[base_indices.at[3 * triangle + corner]];
}

// P and the linear normal are linear in (u, v). From a corner, not from u = v = 0, which may lie far away.
struct BaseTriangle {
    vec3 corner;
    vec2 corner_uv;
    vec3 along_u;
    vec3 along_v;
    vec3 corner_normal;
    vec3 normal_along_u;
    vec3 normal_along_v;
    vec3 facet_normal;  // unit vector
    float handedness;   // -1 where the chart is mirrored, else 1
};

BaseTriangle base_triangle(int triangle) {
    BaseVertex first = base_vertex(triangle, 0);
    BaseVertex second = base_vertex(triangle, 1);
    BaseVertex third = base_vertex(triangle, 2);
    vec3 side = second.position - first.position;
    vec3 other_side = third.position - first.position;
    vec3 normal_change = second.normal - first.normal;
    vec3 other_normal_change = third.normal - first.normal;
    vec2 way = vec2(second.u - first.u, second.v - first.v);
    vec2 other_way = vec2(third.u - first.u, third.v - first.v);
    float area = way.x * other_way.y - other_way.x * way.y;
    return BaseTriangle(first.position, vec2(first.u, first.v), (side * other_way.y - other_side * way.y) / area,
                        (other_side * way.x - side * other_way.x) / area, first.normal,
                        (normal_change * other_way.y - other_normal_change * way.y) / area,
                        (other_normal_change * way.x - normal_change * other_way.x) / area,
                        normalize(cross(side, other_side)), area < 0.0 ? -1.0 : 1.0);
}

vec3 linear_normal(BaseTriangle triangle, vec2 uv) {
    vec2 way = uv - triangle.corner_uv;
    return triangle.corner_normal + way.x * triangle.normal_along_u + way.y * triangle.normal_along_v;
}

// Of the relief whose offset along N changes by `slope` with u and v, by the tangent frame there: how N itself turns is left
// out.
vec3 relief_normal(BaseTriangle triangle, vec2 uv, vec2 slope) {
    vec3 normal = normalize(linear_normal(triangle, uv));
    return normalize(triangle.handedness *
                     cross(triangle.along_u + slope.x * normal, triangle.along_v + slope.y * normal));
}

// The same with how N turns, at height h: the normal of S itself.
vec3 displaced_normal(BaseTriangle triangle, vec2 uv, float h, vec2 slope) {
    vec3 linear = linear_normal(triangle, uv);
    vec3 normal = normalize(linear);
    float above = (h - 1.0) * scene.height_scale / length(linear);
    vec3 turn_u = triangle.normal_along_u - normal * dot(normal, triangle.normal_along_u);
    vec3 turn_v = triangle.normal_along_v - normal * dot(normal, triangle.normal_along_v);
    return normalize(triangle.handedness * cross(triangle.along_u + slope.x * normal + above * turn_u,
                                                 triangle.along_v + slope.y * normal + above * turn_v));
}

// (u, v) of a vector in the triangle's plane.
vec2 way_in_chart(BaseTriangle triangle, vec3 way) {
    vec3 across = cross(triangle.along_u, triangle.along_v);
    return vec2(dot(cross(way, triangle.along_v), across), dot(cross(triangle.along_u, way), across)) /
           dot(across, across);
}

#endif
