#pragma once

#include "scene/surface/base_mesh.hpp"
#include "scene/surface/base_source.hpp"

#include <string>

namespace reliefbench {

/// The magnitude of κ up to which a generated base does not overlap itself; infinite where it never does.
double max_curvature(BaseSource::Kind kind);

/// Why a generated base cannot have this curvature (one that would overlap itself, or is not finite); empty when it
/// can.
std::string curvature_problem(const BaseSource& source);

/// Why a relief this deep would fold on it, κ·H ≥ 1; empty when it does not. Generated bases only.
std::string folding_problem(const BaseSource& source, double height_scale);

/// Of a = u − ½, b = v − ½ over the unit square, with the centre at the origin and its normal z. Cylinder:
/// P = (a, sin(κb)/κ, (cos(κb) − 1)/κ); sphere, with r = hypot(a, b): P = (sin(κr)·a/(κr), sin(κr)·b/(κr),
/// (cos(κr) − 1)/κ); saddle: P = (a, b, κ(a² − b²)/2). `source.segments` a side, each of two triangles, with the
/// normals of the smooth surface. For a generated kind without a curvature_problem.
BaseMesh generate_base(const BaseSource& source);

}  // namespace reliefbench
