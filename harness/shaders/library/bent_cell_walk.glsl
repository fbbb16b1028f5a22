// What cell_walk.glsl does for a straight ray, for one that bends: its way in cells is a parabola, which can turn back
// along an axis, so that either wall of a node may be the one that it meets there.

#include "bent_way.glsl"

CellRay to_cells(ReliefRay ray, vec2 entry) {
    CellRay cells;
    cells.size = height_map_size();
    cells.origin = entry - floor(entry);
    cells.direction = straight_offset(ray) * vec2(cells.size);
    cells.bend = ray.uv_bend * vec2(cells.size);
    cells.relief = ray;
    return cells;
}

vec2 cells_along(CellRay ray, float s) { return ray.origin + s * (ray.direction + s * ray.bend); }

vec2 speed_in_cells(CellRay ray, float s) { return ray.direction + 2.0 * s * ray.bend; }

// Along each axis.
bvec2 goes_forward(CellRay ray, float s) {
    vec2 speed = speed_in_cells(ray, s);
    return bvec2(speed.x > 0.0 || (speed.x == 0.0 && ray.bend.x > 0.0),
                 speed.y > 0.0 || (speed.y == 0.0 && ray.bend.y > 0.0));
}

Node node_at(CellRay ray, Place place, int tree_level) {
    Node node;
    node.index = place.cell >> tree_level;
    node.low = node.index << tree_level;
    node.high = min(node.low + (1 << tree_level), ray.size);
    vec2 at = cells_along(ray, place.s) - vec2(place.shift);
    vec2 below = max(at - vec2(node.low), 0.0);
    vec2 above = max(vec2(node.high) - at, 0.0);
    vec2 speed = speed_in_cells(ray, place.s);
    node.walls = place.s + vec2(first_wall(below.x, above.x, speed.x, ray.bend.x, node.forward.x),
                                first_wall(below.y, above.y, speed.y, ray.bend.y, node.forward.y));
    node.exit = clamp(min(node.walls.x, node.walls.y), place.s, end_of_ray(ray.relief));
    return node;
}

// Never back over a wall along an axis along which the ray does not turn before s.
Place move_within(CellRay ray, Place place, Node node, float s) {
    ivec2 there = ivec2(floor(cells_along(ray, s))) - place.shift;
    bvec2 forward = goes_forward(ray, s);
    ivec2 onward = mix(min(there, place.cell), max(there, place.cell), forward);
    there = mix(there, onward, equal(forward, goes_forward(ray, place.s)));
    return Place(clamp(there, node.low, node.high - 1), place.shift, s);
}

Place cross_wall(CellRay ray, Place place, Node node) {
    place = move_within(ray, place, node, node.exit);
    bool along_u = node.walls.x <= node.walls.y;
    bvec2 crossed = bvec2(along_u, !along_u);
    ivec2 beyond = mix(node.low - 1, node.high, node.forward);
    ivec2 wrapped = mix(mix(beyond, ivec2(0), equal(beyond, ray.size)), ray.size - 1, lessThan(beyond, ivec2(0)));
    place.shift += mix(ivec2(0), beyond - wrapped, crossed);
    place.cell = mix(place.cell, wrapped, crossed);
    return place;
}

// The fraction of the way in s from `place` to `exit` at which the ray meets the bilinear surface between the corners of a
// cell, or of a node of `size` cells, whose lower corner is `low`; or no_crossing.
float cross_corners(CellRay ray, Place place, float exit, vec4 corners, ivec2 low, vec2 size) {
    float way = exit - place.s;
    vec2 from = cells_along(ray, place.s) - vec2(low + place.shift);
    return cross_bent_patch(corners, vec3(from / size, height_of_ray(ray.relief, place.s)),
                            way * vec3(speed_in_cells(ray, place.s) / size, slope_of_ray(ray.relief, place.s)),
                            way * way * vec3(ray.bend / size, ray.relief.bend));
}

float cross_cell(CellRay ray, Place place, Node cell_node) {
    vec4 corners = tap_height_cell(place.cell);
    if (place.s == 0.0 && enters_surface(patch_height(corners, ray.origin - vec2(place.cell + place.shift)))) return 0.0;
    return cross_corners(ray, place, cell_node.exit, corners, place.cell, vec2(1.0));
}
