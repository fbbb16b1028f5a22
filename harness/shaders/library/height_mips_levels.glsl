// Means of the finer level over a texel's area, so that every level has the map's mean. Where the finer level has an odd
// side a texel covers more than two of its texels, the outer ones in part.
void prepare(ivec2 texel) {
    vec2 extent = vec2(previous_size()) / vec2(map_size());
    vec2 low = vec2(texel) * extent;
    vec2 high = low + extent;
    ivec2 first = ivec2(low);
    float sum = 0.0;
    for (int j = 0; j <= int(ceil(extent.y)); ++j) {
        for (int i = 0; i <= int(ceil(extent.x)); ++i) {
            ivec2 finer = first + ivec2(i, j);
            vec2 covered = max(min(high, vec2(finer + 1)) - max(low, vec2(finer)), 0.0);
            sum += covered.x * covered.y * previous_level(finer).r;
        }
    }
    write_map(vec4(sum / (extent.x * extent.y)));
}
