#include "patches.glsl"

layout(vertices = 4) out;

void main() {
    pass_corner();
    if (gl_InvocationID == 0) set_tessellation_factor(float(factor));
}
