#pragma once

#include "scene/surface/base_mesh.hpp"
#include "scene/surface/base_source.hpp"

#include <cstddef>

namespace reliefbench {

/// The mesh of a file, placed by `source.fit`, with charts, and with normals where the file has none: for each place
/// the sum of the facets' normals there, weighted by the triangle's area and its angle at the place. What cannot be
/// drawn is left out, and BaseMesh::warnings says so. Throws Error as read_mesh_file does, and where no triangle is
/// left or a number is not finite.
BaseMesh load_file_base(const BaseSource& source);

/// Triangles whose prism, from the base down to `height_scale` below it along the normals, turns inside out: what the
/// relief is there depends on who draws it.
std::size_t count_folded_prisms(const BaseMesh& mesh, double height_scale);

}  // namespace reliefbench
