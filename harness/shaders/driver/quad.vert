// The quad of the patch as a triangle strip; of a base that is not flat its triangles, three vertices for each.

#include "scene.glsl"
#ifdef RELIEFBENCH_CURVED
#include "base_mesh.glsl"

layout(location = 0) flat out int triangle_index;

void main() {
    triangle_index = gl_VertexIndex / 3;
    gl_Position = scene.clip_from_world * vec4(base_vertex(triangle_index, gl_VertexIndex % 3).position, 1.0);
}
#else

void main() {
    vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
#ifdef RELIEFBENCH_POLYGON_HEIGHT
    gl_Position = scene.clip_from_world * vec4(surface_point(corner, scene.polygon_height), 1.0);
#else
    gl_Position = scene.clip_from_world * vec4(surface_point(corner, 1.0), 1.0);
#endif
}
#endif
