#include "quadtree_walk.glsl"

// As published: the chord between the filtered heights at both ends of the node.
float cross_leaf_linear(ReliefRay ray, Place place, Node node) {
    float h = tap_height(point_on_ray(ray, place.s));
    float above = height_of_ray(ray, place.s) - h;
    if (above <= 0.0 || (place.s == 0.0 && enters_surface(h))) return 0.0;
    float below = tap_height(point_on_ray(ray, node.exit)) - height_of_ray(ray, node.exit);
    return below < 0.0 ? no_crossing : above / (above + below);
}

// The bilinear patch between the corners of a node above the cells: the surface of every 2^level-th texel.
float cross_leaf_corners(CellRay ray, Place place, Node node) {
    vec4 corners = vec4(tap_height_texel(node.low), tap_height_texel(ivec2(node.high.x, node.low.y)),
                        tap_height_texel(ivec2(node.low.x, node.high.y)), tap_height_texel(node.high));
    vec2 size = vec2(node.high - node.low);
#ifdef RELIEFBENCH_BENT_RAY
    return cross_corners(ray, place, node.exit, corners, node.low, size);
#else
    vec2 corner = (ray.origin - vec2(node.low + place.shift)) / size;
    vec2 way = ray.direction / size;
    return cross_patch(corners, vec3(corner + place.s * way, height_of_ray(ray.relief, place.s)),
                       vec3(corner + node.exit * way, height_of_ray(ray.relief, node.exit)));
#endif
}

// The fraction of the ray's way from its place to the leaf's wall at which it hits, or no_crossing.
float cross_leaf(ReliefRay ray, CellRay cells, int leaf_level, inout Walk walk) {
    // The exact leaf reads a cell's corners in one tap, which makes a look at its maximum needless.
    if (leaf == leaf_exact && leaf_level == 0) return cross_cell(cells, walk.place, walk.node);
    float top = tap_map_texel(quadtree, walk.node.index, leaf_level).r;
#ifdef RELIEFBENCH_BENT_RAY
    if (lowest_between(ray, walk.place.s, walk.node.exit) >= top) return no_crossing;
#else
    if (height_of_ray(ray, walk.node.exit) >= top) return no_crossing;
#endif
    if (leaf == leaf_exact) return cross_leaf_corners(cells, walk.place, walk.node);
    if (leaf == leaf_linear) return cross_leaf_linear(ray, walk.place, walk.node);
    walk.place = move_within(cells, walk.place, walk.node, max(walk.place.s, s_at_height(ray, top)));
    return 0.0;
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
    int finest = level_by_mip ? max(finest_level, int(max(ray.level, 0.0))) : finest_level;
    return min(finest, textureQueryLevels(quadtree) - 1);
}

int step_cap(ReliefRay ray) {
    return adaptive ? max(1, int(mix(float(max_steps), float(min_steps), ray.to_eye.z))) : max_steps;
}

Trace trace(ReliefRay ray) {
    vec2 entry = ray.uv * vec2(height_map_size()) - 0.5;
    CellRay cells = to_cells(ray, entry);
    int leaf_level = finest_leaf(ray);
    // Without the ascent the walk goes up nowhere.
    int top_level = ascend ? textureQueryLevels(quadtree) - 1 : 0;
    Walk walk = begin_walk(entry, start_level(cells, leaf_level));
    while (walk_to_leaf(cells, quadtree, leaf_level, top_level, step_cap(ray), walk)) {
        float fraction = cross_leaf(ray, cells, leaf_level, walk);
        if (fraction >= 0.0) return hit_on_ray(mix(walk.place.s, walk.node.exit, fraction), walk.steps);
        pass_node(cells, top_level, walk);
    }
    return end_of_walk(walk);
}
