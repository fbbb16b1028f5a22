#include "quadtree_walk.glsl"

// The box over a node reaches from h = 0 to the node's highest point. The ray goes on to where it enters the box and
// looks at the boxes beneath there, or passes above the box to its wall. In a cell it is intersected with the surface.
Trace trace(ReliefRay ray) {
    vec2 entry = ray.uv * vec2(height_map_size()) - 0.5;
    CellRay cells = to_cells(ray, entry);
    int root = textureQueryLevels(quadtree) - 1;
    Walk walk = begin_walk(entry, root);
    while (walk_to_leaf(cells, quadtree, 0, root, max_steps, walk)) {
        float fraction = cross_cell(cells, walk.place, walk.node);
        if (fraction >= 0.0) return hit_on_ray(mix(walk.place.s, walk.node.exit, fraction), walk.steps);
        pass_node(cells, root, walk);
    }
    return end_of_walk(walk);
}
