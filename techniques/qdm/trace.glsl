#include "cell_walk.glsl"

// Traversal of the maximum quadtree over bilinear cells: each iteration goes one level down or one node on. None is
// skipped, and none repeats.

// The node's highest point; beneath it the ray may hit.
float tap_top(Node node, int tree_level) {
    return tap_map_texel(quadtree, node.index, tree_level).r;
}

// As published: the chord between the filtered heights at both ends of the node.
float cross_leaf_linear(ReliefRay ray, Place place, Node node) {
    float above = 1.0 - place.s - tap_height(point_on_ray(ray, place.s));
    if (above <= 0.0) return 0.0;
    float below = tap_height(point_on_ray(ray, node.exit)) - (1.0 - node.exit);
    return below < 0.0 ? no_crossing : above / (above + below);
}

// The bilinear patch between the corners of a node above the cells: the surface of every 2^level-th texel.
float cross_leaf_corners(CellRay ray, Place place, Node node) {
    vec4 corners = vec4(tap_height_texel(node.low), tap_height_texel(ivec2(node.high.x, node.low.y)),
                        tap_height_texel(ivec2(node.low.x, node.high.y)), tap_height_texel(node.high));
    vec2 size = vec2(node.high - node.low);
    vec2 corner = (ray.origin - vec2(node.low + place.shift)) / size;
    vec2 way = ray.direction / size;
    return cross_patch(corners, vec3(corner + place.s * way, 1.0 - place.s),
                       vec3(corner + node.exit * way, 1.0 - node.exit));
}

float cross_leaf(ReliefRay ray, CellRay cells, Place place, Node node, int leaf_level) {
    if (leaf == leaf_none) return 0.0;
    if (leaf == leaf_linear) return cross_leaf_linear(ray, place, node);
    return leaf_level == 0 ? cross_cell(cells, place, node) : cross_leaf_corners(cells, place, node);
}

// Nodes about a quarter of the way that the ray covers in the relief: larger ones rarely let it pass.
const int start_below_way = 2;

int start_level(CellRay ray, int leaf_level) {
    int way = int(max(abs(ray.direction.x), abs(ray.direction.y)));
    int top = textureQueryLevels(quadtree) - 1;
    return clamp(findMSB(way) - start_below_way, leaf_level, top);
}

// Drobot's level of detail. The sampler's rule, rounded down: a texel of that mip level covers no more than a pixel
// along the direction in which the texture is seen smallest.
int finest_leaf(ReliefRay ray) {
    int finest = finest_level;
    if (level_by_mip) {
        vec2 size = vec2(height_map_size());
        vec2 across = dFdx(ray.uv) * size;
        vec2 down = dFdy(ray.uv) * size;
        float texels = sqrt(max(dot(across, across), dot(down, down)));
        finest = max(finest, int(log2(max(texels, 1.0))));
    }
    return min(finest, textureQueryLevels(quadtree) - 1);
}

int step_cap(ReliefRay ray) {
    return adaptive ? max(1, int(mix(float(max_steps), float(min_steps), ray.to_eye.z))) : max_steps;
}

Trace trace(ReliefRay ray) {
    vec2 entry = ray.uv * vec2(height_map_size()) - 0.5;
    CellRay cells = to_cells(ray, entry);
    Place place = enter_map(entry);
    int leaf_level = finest_leaf(ray);
    // The exact leaf reads a cell's corners in one tap, which makes a look at its maximum needless.
    bool looks_at_leaves = leaf != leaf_exact || leaf_level > 0;
    int tree_level = start_level(cells, leaf_level);
    int cap = step_cap(ray);

    for (int steps = 1; steps <= cap; ++steps) {
        Node node = node_at(cells, place, tree_level);
        bool is_leaf = tree_level == leaf_level;
        if (!is_leaf || looks_at_leaves) {
            float top = tap_top(node, tree_level);
            bool blocked = 1.0 - node.exit < top;
            if (blocked && (!is_leaf || leaf == leaf_none)) place = move_within(cells, place, node, max(place.s, 1.0 - top));
            if (blocked && !is_leaf) {
                tree_level -= 1;
                continue;
            }
            is_leaf = is_leaf && blocked;
        }
        if (is_leaf) {
            float fraction = cross_leaf(ray, cells, place, node, leaf_level);
            if (fraction >= 0.0) return hit_on_ray(mix(place.s, node.exit, fraction), steps);
        }
        if (node.exit >= 1.0) return hit_on_ray(1.0, steps);

        place = cross_wall(cells, place, node);
        // The parent that the ray just left had blocked it; the one that it enters may not.
        bool new_parent = (place.cell >> (tree_level + 1)) != (node.index >> 1);
        if (ascend && new_parent) tree_level = min(tree_level + 1, textureQueryLevels(quadtree) - 1);
    }
    return unconverged(hit_on_ray(place.s, cap));
}
