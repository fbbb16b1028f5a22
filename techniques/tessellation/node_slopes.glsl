#include "slope_bounds.glsl"

void prepare(ivec2 node) {
    ivec2 child = 2 * node;
    vec4 lower = join_slopes(previous_level(child), previous_level(child + ivec2(1, 0)));
    vec4 upper = join_slopes(previous_level(child + ivec2(0, 1)), previous_level(child + ivec2(1, 1)));
    write_map(join_slopes(lower, upper));
}
