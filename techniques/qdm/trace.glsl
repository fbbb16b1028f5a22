#include "cell_walk.glsl"

// Traversal of the maximum quadtree over bilinear cells: each iteration goes one level down or one cell on. None is
// skipped, and none repeats.

// The node's highest point; beneath it the ray may hit.
float tap_top(Node node, int tree_level) {
    return tap_map_texel(quadtree, node.index, tree_level).r;
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
            float fraction = leaf == leaf_exact ? cross_cell(cells, place, node)
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
