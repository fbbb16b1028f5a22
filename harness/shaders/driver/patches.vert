// Corners of a grid of patches: quads of four vertices, or two triangles of three for each. Of a base that is not flat its
// triangles.

#include "scene.glsl"

layout(location = 0) out vec2 vertex_corner;
#ifdef RELIEFBENCH_CURVED
#include "base_mesh.glsl"

layout(location = 1) out vec3 vertex_position;
layout(location = 2) out vec3 vertex_normal;
layout(location = 3) out int vertex_triangle;

void main() {
    vertex_triangle = gl_VertexIndex / patch_corners;
    BaseVertex corner = base_vertex(vertex_triangle, gl_VertexIndex % patch_corners);
    vertex_corner = vec2(corner.u, corner.v);
    vertex_position = corner.position;
    vertex_normal = corner.normal;
}
#else

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
#endif
