#ifndef RELIEFBENCH_BASE_CHARTS_GLSL
#define RELIEFBENCH_BASE_CHARTS_GLSL

// Which triangle of a chart lies over a point of it: the mirror of find_triangle in harness/scene/surface/chart_grid.cpp.

#include "base_mesh.glsl"

// Of barycentric coordinates: what rounding leaves between two triangles.
const float chart_gap = 1e-5;

// The least of the barycentric coordinates: negative outside.
float depth_in_triangle(uint triangle, vec2 uv) {
    BaseVertex first = base_vertex(int(triangle), 0);
    BaseVertex second = base_vertex(int(triangle), 1);
    BaseVertex third = base_vertex(int(triangle), 2);
    vec2 way = vec2(second.u - first.u, second.v - first.v);
    vec2 other_way = vec2(third.u - first.u, third.v - first.v);
    vec2 inside = uv - vec2(first.u, first.v);
    vec2 shares = vec2(inside.x * other_way.y - other_way.x * inside.y, way.x * inside.y - inside.x * way.y) /
                  (way.x * other_way.y - other_way.x * way.y);
    return min(1.0 - shares.x - shares.y, min(shares.x, shares.y));
}

// -1 where there is none.
int triangle_in_cell(BaseChart chart, vec2 uv) {
    uvec2 cell = uvec2(clamp(floor((uv - chart.low) * chart.cells_per_uv), vec2(0.0), vec2(chart.cells) - 1.0));
    uint index = chart.first_cell + cell.y * chart.cells.x + cell.x;
    for (uint entry = base_cell_starts.at[index]; entry < base_cell_starts.at[index + 1]; ++entry) {
        uint triangle = base_cell_triangles.at[entry];
        if (depth_in_triangle(triangle, uv) > -chart_gap) return int(triangle);
    }
    return -1;
}

vec2 chart_size(BaseChart chart) { return vec2(chart.cells) / chart.cells_per_uv; }

// Of (u, v) as a ray has them: a chart that meets itself goes on after its period, by which they are moved to the triangle.
// -1 beside the chart.
int triangle_over(uint index, inout vec2 uv) {
    BaseChart chart = base_charts.at[index];
    bvec2 closed = greaterThan(chart.period, vec2(0.0));
    vec2 period = mix(vec2(1.0), chart.period, closed);
    vec2 turns = mix(vec2(0.0), floor((uv - chart.low) / period), closed);
    vec2 place = uv - turns * period;
    // A chart whose seam runs aslant is wider than its period.
    vec2 last = chart.low + chart_size(chart);
    for (float v = place.y; v == place.y || (closed.y && v <= last.y); v += period.y) {
        for (float u = place.x; u == place.x || (closed.x && u <= last.x); u += period.x) {
            int triangle = triangle_in_cell(chart, vec2(u, v));
            if (triangle < 0) continue;
            uv = vec2(u, v);
            return triangle;
        }
    }
    return -1;
}

bool inside_chart(uint index, vec2 uv) { return triangle_over(index, uv) >= 0; }

// Whether who goes on from there along `way` is beside the chart for ever.
bool has_left_chart(uint index, vec2 uv, vec2 way) {
    BaseChart chart = base_charts.at[index];
    bvec2 closed = greaterThan(chart.period, vec2(0.0));
    vec2 low = chart.low;
    vec2 high = chart.low + chart_size(chart);
    bvec2 below = bvec2(uv.x < low.x && way.x <= 0.0 && !closed.x, uv.y < low.y && way.y <= 0.0 && !closed.y);
    bvec2 above = bvec2(uv.x > high.x && way.x >= 0.0 && !closed.x, uv.y > high.y && way.y >= 0.0 && !closed.y);
    return any(below) || any(above);
}

#endif
