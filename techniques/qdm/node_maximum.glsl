// Each further level: the highest of the four nodes beneath. Sides are powers of two, so nothing is left over.
void prepare(ivec2 texel) {
    ivec2 child = 2 * texel;
    float lower = max(previous_level(child).r, previous_level(child + ivec2(1, 0)).r);
    float upper = max(previous_level(child + ivec2(0, 1)).r, previous_level(child + ivec2(1, 1)).r);
    write_map(vec4(max(lower, upper)));
}
