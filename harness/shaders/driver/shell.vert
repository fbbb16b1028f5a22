// Tetrahedra of the shell: four triangles of three vertices for each, counterclockwise as seen from outside.

#include "shell_prism.glsl"

layout(location = 0) flat out int tetrahedron_index;
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
layout(location = 1) flat out int opposite_corner;  // to the face
#endif

const int faces[12] = int[](0, 1, 2, 2, 1, 3, 2, 3, 0, 0, 3, 1);

void main() {
    tetrahedron_index = gl_VertexIndex / 12;
    Tetrahedron tetrahedron = shell_tetrahedron(tetrahedron_index);
    int corner = faces[gl_VertexIndex % 12];
    if (tetrahedron.is_inverted && (corner == 1 || corner == 2)) corner = 3 - corner;
#ifdef RELIEFBENCH_GRADIENTS_FROM_RESULT
    int face = gl_VertexIndex % 12 / 3;
    opposite_corner = (face + 3) % 4;
    if (tetrahedron.is_inverted && (opposite_corner == 1 || opposite_corner == 2)) opposite_corner = 3 - opposite_corner;
#endif
    gl_Position = scene.clip_from_world * vec4(tetrahedron.corners[corner].position, 1.0);
}
