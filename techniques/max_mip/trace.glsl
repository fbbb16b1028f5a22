#include "cell_walk.glsl"

// The box over a node reaches from h = 0 to the node's highest point. The ray goes on to where it enters the box and
// looks at the box beneath there, or passes above the box to its wall. In a cell it is intersected with the surface.
Trace trace(ReliefRay ray) {
    vec2 entry = ray.uv * vec2(height_map_size()) - 0.5;
    CellRay cells = to_cells(ray, entry);
    Place place = enter_map(entry);
    int root = textureQueryLevels(maximum) - 1;
    int tree_level = root;

    for (int steps = 1; steps <= max_steps; ++steps) {
        Node node = node_at(cells, place, tree_level);
        if (tree_level > 0) {
            float box_top = tap_map_texel(maximum, node.index, tree_level).r;
            if (1.0 - node.exit < box_top) {
                place = move_within(cells, place, node, max(place.s, 1.0 - box_top));
                tree_level -= 1;
                continue;
            }
        } else {
            float fraction = cross_cell(cells, place, node);
            if (fraction >= 0.0) return hit_on_ray(mix(place.s, node.exit, fraction), steps);
        }
        if (node.exit >= 1.0) return hit_on_ray(1.0, steps);

        place = cross_wall(cells, place, node);
        // Up where the wall is the parent's too: the ray came down through the parent that it leaves.
        bool new_parent = (place.cell >> (tree_level + 1)) != (node.index >> 1);
        if (new_parent) tree_level = min(tree_level + 1, root);
    }
    return unconverged(hit_on_ray(place.s, max_steps));
}
