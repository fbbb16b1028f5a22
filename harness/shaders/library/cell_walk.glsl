// A ray's walk over bilinear cells and the square nodes of a quadtree above them, shared by the hierarchical techniques.
// Cell (i, j) lies between the texel centres (i, j) and (i+1, j+1); a node of level n covers 2^n cells on a side.
// Where the ray is, is kept in whole cells; ray parameters only decide which wall comes first. So nothing is skipped by
// rounding, and nothing needs pushing over a wall. What differs for rays that bend stands in bent_cell_walk.glsl.

#include "bilinear_patch.glsl"

// A ray that is slower than this along an axis, in cells over its whole length, never meets a wall across it.
const float slowest = 1e-12;

struct CellRay {
    vec2 origin;     // in cells, relative to the cell in which the ray enters
    vec2 direction;  // cells travelled from h = 1 to h = 0
#ifdef RELIEFBENCH_BENT_RAY
    vec2 bend;       // cells for each s^2
#else
    vec2 inverse;
    bvec2 forward;
#endif
    ivec2 size;      // of the map
    ReliefRay relief;
};

struct Place {
    ivec2 cell;   // in [0, map size)
    ivec2 shift;  // what to add to `cell` to get it relative to the entry, across repeats of the map
    float s;
};

// A node of the tree, cut off at the map's edge, and the ray's way out of it.
struct Node {
    ivec2 index;
    ivec2 low;
    ivec2 high;  // exclusive
    vec2 walls;  // ray parameters of its two walls ahead
    float exit;
#ifdef RELIEFBENCH_BENT_RAY
    bvec2 forward;  // along each axis: whether the wall that is met is the higher one
#endif
};

#ifndef RELIEFBENCH_BENT_RAY
// `entry`: where the ray enters the relief, in cells.
CellRay to_cells(ReliefRay ray, vec2 entry) {
    CellRay cells;
    cells.size = height_map_size();
    cells.origin = entry - floor(entry);
    cells.direction = straight_offset(ray) * vec2(cells.size);
    bvec2 still = lessThan(abs(cells.direction), vec2(slowest));
    cells.forward = bvec2(still.x || cells.direction.x > 0.0, still.y || cells.direction.y > 0.0);
    cells.inverse = 1.0 / mix(cells.direction, vec2(slowest), still);
    cells.relief = ray;
    return cells;
}
#endif

Place enter_map(vec2 entry) {
    ivec2 size = height_map_size();
    ivec2 first = ivec2(floor(entry));
    ivec2 cell = first - size * ivec2(floor(vec2(first) / vec2(size)));
    // The division may round across a whole number.
    cell = (cell + size) % size;
    return Place(cell, -cell, 0.0);
}

#ifdef RELIEFBENCH_BENT_RAY
#include "bent_cell_walk.glsl"
#else
Node node_at(CellRay ray, Place place, int tree_level) {
    Node node;
    node.index = place.cell >> tree_level;
    node.low = node.index << tree_level;
    node.high = min(node.low + (1 << tree_level), ray.size);
    node.walls = (vec2(place.shift + mix(node.low, node.high, ray.forward)) - ray.origin) * ray.inverse;
    node.exit = clamp(min(node.walls.x, node.walls.y), place.s, end_of_ray(ray.relief));
    return node;
}

// Moves on to parameter s within `node`, never backwards.
Place move_within(CellRay ray, Place place, Node node, float s) {
    ivec2 there = ivec2(floor(ray.origin + s * ray.direction)) - place.shift;
    there = mix(min(there, place.cell), max(there, place.cell), ray.forward);
    return Place(clamp(there, node.low, node.high - 1), place.shift, s);
}

// Through the nearer wall into the neighbouring cell, which may lie in the next repeat of the map.
Place cross_wall(CellRay ray, Place place, Node node) {
    place = move_within(ray, place, node, node.exit);
    bool along_u = node.walls.x <= node.walls.y;
    bvec2 crossed = bvec2(along_u, !along_u);
    ivec2 beyond = mix(node.low - 1, node.high, ray.forward);
    ivec2 wrapped = mix(mix(beyond, ivec2(0), equal(beyond, ray.size)), ray.size - 1, lessThan(beyond, ivec2(0)));
    place.shift += mix(ivec2(0), beyond - wrapped, crossed);
    place.cell = mix(place.cell, wrapped, crossed);
    return place;
}

// The fraction of the ray's way from `place` through its cell, a node of level 0, at which it meets the bilinear surface,
// or no_crossing.
float cross_cell(CellRay ray, Place place, Node cell_node) {
    vec4 corners = tap_height_cell(place.cell);
    vec2 corner = ray.origin - vec2(place.cell + place.shift);
    vec3 from = vec3(corner + place.s * ray.direction, height_of_ray(ray.relief, place.s));
    if (place.s == 0.0 && enters_surface(patch_height(corners, from.xy))) return 0.0;
    vec3 to = vec3(corner + cell_node.exit * ray.direction, height_of_ray(ray.relief, cell_node.exit));
    return cross_patch(corners, from, to);
}
#endif
