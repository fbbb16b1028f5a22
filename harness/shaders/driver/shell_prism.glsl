#ifndef RELIEFBENCH_SHELL_PRISM_GLSL
#define RELIEFBENCH_SHELL_PRISM_GLSL

// The shell between the base and the floor h = 0: of each triangle a prism in three tetrahedra, in each of which (u, v, h)
// is linear (Porumbescu et al. 2005; Hirche et al. 2004). A side of a prism is cut along the diagonal that begins at the
// base's end whose position precedes, so that the prisms on both sides of it agree, across seams of charts too.

#include "base_mesh.glsl"
#include "scene.glsl"

const int tetrahedra_per_prism = 3;

struct ShellCorner {
    vec3 position;
    vec3 place;  // patch coordinates and h
};

struct Tetrahedron {
    ShellCorner corners[4];
    // Whether corner 3 lies on the side of corners 0, 1, 2 from which they go counterclockwise.
    bool is_inverted;
};

bool precedes(vec3 a, vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

ShellCorner shell_corner(BaseVertex vertex, bool on_floor) {
    float depth = on_floor ? scene.height_scale : 0.0;
    return ShellCorner(vertex.position - depth * vertex.normal, vec3(vertex.u, vertex.v, on_floor ? 0.0 : 1.0));
}

// With the triangle's vertices in order, v0 to v2, those of the base and w0 to w2 below them: (v0, v1, v2, w2),
// (v0, v1, w1, w2), (v0, w0, w1, w2).
Tetrahedron shell_tetrahedron(int index) {
    int triangle = index / tetrahedra_per_prism;
    int first_on_floor = tetrahedra_per_prism - index % tetrahedra_per_prism;
    BaseVertex ordered[3];
    for (int i = 0; i < 3; ++i) ordered[i] = base_vertex(triangle, i);
    bool is_odd = false;
    for (int i = 0; i < 3; ++i) {
        int at = i == 1 ? 1 : 0;  // 0 and 1, 1 and 2, 0 and 1
        if (!precedes(ordered[at + 1].position, ordered[at].position)) continue;
        BaseVertex later = ordered[at];
        ordered[at] = ordered[at + 1];
        ordered[at + 1] = later;
        is_odd = !is_odd;
    }
    Tetrahedron result;
    for (int i = 0; i < 4; ++i) {
        bool on_floor = i >= first_on_floor;
        result.corners[i] = shell_corner(ordered[on_floor ? i - 1 : i], on_floor);
    }
    result.is_inverted = (first_on_floor == 2) != is_odd;
    return result;
}

#endif
