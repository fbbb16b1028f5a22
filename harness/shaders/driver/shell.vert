// Tetrahedra of the shell: four triangles of three vertices for each, counterclockwise as seen from outside.

#include "shell_prism.glsl"

layout(location = 0) flat out int tetrahedron_index;

const int faces[12] = int[](0, 1, 2, 2, 1, 3, 2, 3, 0, 0, 3, 1);

void main() {
    tetrahedron_index = gl_VertexIndex / 12;
    Tetrahedron tetrahedron = shell_tetrahedron(tetrahedron_index);
    int corner = faces[gl_VertexIndex % 12];
    if (tetrahedron.is_inverted && (corner == 1 || corner == 2)) corner = 3 - corner;
    gl_Position = scene.clip_from_world * vec4(tetrahedron.corners[corner].position, 1.0);
}
