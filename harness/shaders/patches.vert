// Corners of a grid of quad patches, four vertices each.

#include "scene.glsl"

layout(location = 0) out vec2 vertex_corner;

void main() {
    int index = gl_VertexIndex / 4;
    ivec2 cell = scene.first_patch + ivec2(index % scene.patch_count.x, index / scene.patch_count.x);
    ivec2 corner = cell + ivec2(gl_VertexIndex & 1, (gl_VertexIndex >> 1) & 1);
    vertex_corner = vec2(corner) / vec2(scene.patches_per_side);
}
