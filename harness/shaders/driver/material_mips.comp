// One texel of one level of a mip chain of the material (harness/technique/material_mips.hpp): the mean of the finer level
// over the texel's area, so that every level has the map's mean. Where the finer level has an odd side a texel covers more
// than two of its texels, the outer ones in part (a polyphase box filter).

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0) uniform sampler2D finer_level;
layout(set = 0, binding = 1, RELIEFBENCH_TEXEL_FORMAT) uniform writeonly image2D coarser_level;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(coarser_level);
    if (any(greaterThanEqual(texel, size))) return;
    ivec2 finer_size = textureSize(finer_level, 0);
    vec2 extent = vec2(finer_size) / vec2(size);
    vec2 low = vec2(texel) * extent;
    vec2 high = low + extent;
    ivec2 first = ivec2(low);
    vec4 sum = vec4(0.0);
    for (int j = 0; j <= int(ceil(extent.y)); ++j) {
        for (int i = 0; i <= int(ceil(extent.x)); ++i) {
            ivec2 finer = first + ivec2(i, j);
            vec2 covered = max(min(high, vec2(finer + 1)) - max(low, vec2(finer)), 0.0);
            sum += covered.x * covered.y * texelFetch(finer_level, min(finer, finer_size - 1), 0);
        }
    }
    imageStore(coarser_level, texel, sum / (extent.x * extent.y));
}
