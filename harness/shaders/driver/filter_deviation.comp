// Filtered taps at given texture coordinates, to be compared with exact interpolation on the CPU.

#include "taps.glsl"

layout(local_size_x = 64) in;

struct FilteredTap {
    vec2 uv;
    float h;
    float unused;
};

layout(set = 0, binding = 5, std430) buffer Taps { FilteredTap taps[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < taps.length()) taps[index].h = tap_height(taps[index].uv);
}
