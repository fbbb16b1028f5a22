// Corners of a grid of patches: quads of four vertices, or two triangles of three for each.

#include "scene.glsl"

layout(location = 0) out vec2 vertex_corner;

void main() {
    int index = gl_VertexIndex / patch_corners;
    int vertex = gl_VertexIndex % patch_corners;
    ivec2 corner = ivec2(vertex & 1, vertex >> 1);
    if (patch_corners == 3) {
        // The second triangle is the first turned by half.
        if ((index & 1) == 1) corner = 1 - corner;
        index >>= 1;
    }
    ivec2 cell = scene.first_patch + ivec2(index % scene.patch_count.x, index / scene.patch_count.x);
    vertex_corner = vec2(cell + corner) / vec2(scene.patches_per_side);
}
