#pragma once

#include "scene/camera.hpp"
#include "scene/surface/base_mesh.hpp"

namespace reliefbench {

/// What cameras need to know of a base of triangles and of the floor, H = `height_scale` below it along N.

/// Perspective: a view depth that all of both exceeds; where the eye stands within or before them, a small one above 0.
double nearest_depth(const BaseMesh& mesh, const Camera& camera, double height_scale);

/// Parallel rays: the bounding rectangle of their shadows along the ray on z = 0, and the range of z that they span.
ParallelWindow parallel_window(const BaseMesh& mesh, const Camera& camera, double height_scale);

}  // namespace reliefbench
