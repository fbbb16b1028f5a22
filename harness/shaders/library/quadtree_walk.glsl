// A ray's walk down and up a quadtree of maxima over bilinear cells (maximum_mip.glsl), from one leaf that it may hit to
// the next. What is done in a leaf is the technique's: pixels that are processed together reach their leaves together,
// which costs a processor with wide registers less than a look at a leaf in every step of some pixel.

#include "cell_walk.glsl"

struct Walk {
    Place place;
    Node node;
    int tree_level;
    int steps;    // nodes looked at
    bool at_end;  // the ray has come to h = 0
#ifdef RELIEFBENCH_BENT_RAY
    bool missed;  // or has left the relief at h = 1
#endif
};

Walk begin_walk(vec2 entry, int tree_level) {
    Walk walk;
    walk.place = enter_map(entry);
    walk.tree_level = tree_level;
    walk.steps = 0;
    walk.at_end = false;
#ifdef RELIEFBENCH_BENT_RAY
    walk.missed = false;
#endif
    return walk;
}

// Over the wall of a node without a hit; and a level up, to `top_level` at most, where the wall is the parent's too: the
// parent that the ray leaves had blocked it, the one that it enters may not.
void pass_node(CellRay ray, int top_level, inout Walk walk) {
    walk.at_end = walk.node.exit >= end_of_ray(ray.relief);
    if (walk.at_end) {
#ifdef RELIEFBENCH_BENT_RAY
        walk.missed = leaves_above(ray.relief);
#endif
        walk.place.s = walk.node.exit;
        return;
    }
    walk.place = cross_wall(ray, walk.place, walk.node);
    bool new_parent = (walk.place.cell >> (walk.tree_level + 1)) != (walk.node.index >> 1);
    if (new_parent && walk.tree_level < top_level) walk.tree_level += 1;
}

// To the next node of `leaf_level` on the way: a node that the ray leaves above its maximum is passed (one that bends may
// be lowest before it leaves), in any other the ray goes on to that height and one level down. False at the ray's end, or
// when `cap` nodes have been looked at.
bool walk_to_leaf(CellRay ray, sampler2D tree, int leaf_level, int top_level, int cap, inout Walk walk) {
    while (walk.steps < cap && !walk.at_end) {
        walk.node = node_at(ray, walk.place, walk.tree_level);
        walk.steps += 1;
        if (walk.tree_level == leaf_level) return true;
        float top = tap_map_texel(tree, walk.node.index, walk.tree_level).r;
#ifdef RELIEFBENCH_BENT_RAY
        if (lowest_between(ray.relief, walk.place.s, walk.node.exit) < top)
#else
        if (height_of_ray(ray.relief, walk.node.exit) < top)
#endif
        {
            walk.place = move_within(ray, walk.place, walk.node, max(walk.place.s, s_at_height(ray.relief, top)));
            walk.tree_level -= 1;
        } else {
            pass_node(ray, top_level, walk);
        }
    }
    return false;
}

// Where a walk that hit nothing ended.
Trace end_of_walk(Walk walk) {
#ifdef RELIEFBENCH_BENT_RAY
    if (walk.missed) return miss(walk.steps);
#endif
    Trace found = hit_on_ray(walk.place.s, walk.steps);
    return walk.at_end ? found : unconverged(found);
}
