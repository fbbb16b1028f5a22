#include "bilinear_patch.glsl"

// Traversal of the maximum quadtree over bilinear cells. Cell (i, j) lies between the texel centres (i, j) and
// (i+1, j+1). Where the ray is, is kept in whole cells; ray parameters only decide which wall comes first. So each
// iteration goes one level down or one cell on: none is skipped by rounding, and none repeats.

// A ray that is slower than this along an axis, in cells over its whole length, never meets a wall across it.
const float slowest = 1e-12;

struct CellRay {
    vec2 origin;     // in cells, relative to the cell in which the ray enters
    vec2 direction;  // cells travelled from h = 1 to h = 0
    vec2 inverse;
    bvec2 forward;
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
};

CellRay to_cells(ReliefRay ray, vec2 entry) {
    CellRay cells;
    cells.origin = entry - floor(entry);
    cells.direction = ray.max_offset * vec2(height_map_size());
    bvec2 still = lessThan(abs(cells.direction), vec2(slowest));
    cells.forward = bvec2(still.x || cells.direction.x > 0.0, still.y || cells.direction.y > 0.0);
    cells.inverse = 1.0 / mix(cells.direction, vec2(slowest), still);
    return cells;
}

Place enter_map(vec2 entry) {
    ivec2 size = height_map_size();
    ivec2 first = ivec2(floor(entry));
    ivec2 cell = first - size * ivec2(floor(vec2(first) / vec2(size)));
    // The division may round across a whole number.
    cell = (cell + size) % size;
    return Place(cell, -cell, 0.0);
}

Node node_at(CellRay ray, Place place, int tree_level) {
    Node node;
    node.index = place.cell >> tree_level;
    node.low = node.index << tree_level;
    node.high = min(node.low + (1 << tree_level), height_map_size());
    node.walls = (vec2(place.shift + mix(node.low, node.high, ray.forward)) - ray.origin) * ray.inverse;
    node.exit = clamp(min(node.walls.x, node.walls.y), place.s, 1.0);
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
    int axis = node.walls.x <= node.walls.y ? 0 : 1;
    int size = height_map_size()[axis];
    int beyond = ray.forward[axis] ? node.high[axis] : node.low[axis] - 1;
    int wrapped = beyond == size ? 0 : beyond < 0 ? size - 1 : beyond;
    place.shift[axis] += beyond - wrapped;
    place.cell[axis] = wrapped;
    return place;
}

// The node's highest point; beneath it the ray may hit.
float tap_top(Node node, int tree_level) {
    return tap_map_texel(quadtree, node.index, tree_level).r;
}

float cross_leaf_exact(CellRay ray, Place place, Node node) {
    vec4 corners = tap_height_cell(place.cell);
    vec2 corner = ray.origin - vec2(place.cell + place.shift);
    vec3 from = vec3(corner + place.s * ray.direction, 1.0 - place.s);
    vec3 to = vec3(corner + node.exit * ray.direction, 1.0 - node.exit);
    return cross_patch(corners, from, to);
}

// As published: the chord between the filtered heights at both ends of the cell.
float cross_leaf_linear(ReliefRay ray, Place place, Node node) {
    float above = 1.0 - place.s - tap_height(point_on_ray(ray, place.s));
    if (above <= 0.0) return 0.0;
    float below = tap_height(point_on_ray(ray, node.exit)) - (1.0 - node.exit);
    return below < 0.0 ? no_crossing : above / (above + below);
}

// Nodes about a quarter of the way that the ray covers in the relief: larger ones rarely let it pass.
const int start_below_way = 2;

int start_level(CellRay ray) {
    int way = int(max(abs(ray.direction.x), abs(ray.direction.y)));
    int top = textureQueryLevels(quadtree) - 1;
    return clamp(findMSB(way) - start_below_way, 0, top);
}

Trace trace(ReliefRay ray) {
    vec2 entry = ray.uv * vec2(height_map_size()) - 0.5;
    CellRay cells = to_cells(ray, entry);
    Place place = enter_map(entry);
    int tree_level = start_level(cells);

    for (int steps = 1; steps <= max_steps; ++steps) {
        Node node = node_at(cells, place, tree_level);
        bool is_leaf = tree_level == 0;
        // The exact leaf reads the cell's corners in one tap, which makes a look at its maximum needless.
        if (!is_leaf || leaf == leaf_linear) {
            float top = tap_top(node, tree_level);
            bool blocked = 1.0 - node.exit < top;
            if (blocked && !is_leaf) {
                place = move_within(cells, place, node, max(place.s, 1.0 - top));
                tree_level -= 1;
                continue;
            }
            is_leaf = is_leaf && blocked;
        }
        if (is_leaf) {
            float fraction = leaf == leaf_exact ? cross_leaf_exact(cells, place, node)
                                                : cross_leaf_linear(ray, place, node);
            if (fraction >= 0.0) return hit_on_ray(mix(place.s, node.exit, fraction), steps);
        }
        if (node.exit >= 1.0) return hit_on_ray(1.0, steps);

        place = cross_wall(cells, place, node);
        // The parent that the ray just left had blocked it; the one that it enters may not.
        bool new_parent = (place.cell >> (tree_level + 1)) != (node.index >> 1);
        if (new_parent) tree_level = min(tree_level + 1, textureQueryLevels(quadtree) - 1);
    }
    return unconverged(hit_on_ray(place.s, max_steps));
}
