layout(vertices = 4) out;

#include "patches.glsl"

void main() {
    pass_corner();
    if (gl_InvocationID == 0) set_tessellation_factor(float(factor));
}
