#include "stored_cone.glsl"

void prepare(ivec2 texel) {
    float ratio = tap_map_texel(ratios, texel, 0).r;
    float encoded = cone_encoding == cone_encoding_square_root ? sqrt(ratio) : ratio;
    write_map(stored_cone(tap_height_texel(texel), encoded));
}
