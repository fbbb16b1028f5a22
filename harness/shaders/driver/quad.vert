// The quad of the patch as a triangle strip.

#include "scene.glsl"

void main() {
    vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
    gl_Position = scene.clip_from_world * vec4(surface_point(corner, 1.0), 1.0);
}
