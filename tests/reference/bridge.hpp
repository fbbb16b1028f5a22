#pragma once

/// The reference layer behind plain functions and numbers, so that a test can check it without any of its headers (or
/// those of scene): a misunderstanding in a shared header cannot then hide in the test as well.
namespace bridge {

struct Map {
    const float* heights;  // row 0 is v = 0
    int width;
    int height;
    double height_scale;
    double tiling;
    bool repeat;
};

struct View {
    bool perspective;
    double view_angle;
    double azimuth;
    double distance;
    double fov;
    int width;
    int height;
};

/// Writes u, v, h, t. The direction need not be of unit length; t counts in its length.
bool trace_exact(const Map& map, const double origin[3], const double direction[3], double hit[4]);

/// The ray of pixel (i, j) of the view.
void pixel_ray(const View& view, int i, int j, double origin[3], double direction[3]);

/// u, v, h, t of every pixel, row 0 at the top; t = −1 where nothing is hit. Exact with subdivision 0, else the mesh.
void truth_image(const Map& map, const View& view, int subdivision, float* hits);

/// A generated base: κ and segments a side.
struct Base {
    enum class Kind { cylinder, sphere, saddle } kind;
    double curvature;
    int segments;
};

/// Six numbers a ray (origin, direction of unit length) in, four a hit (u, v, h, t) out; t = −1 where nothing is hit.
void trace_curved(const Map& map, const Base& base, const double* rays, int count, double* hits);

}  // namespace bridge
