#pragma once

#include "core/json.hpp"
#include "scene/surface/base_mesh.hpp"
#include "sweep/cell.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Loads each mesh file that the cells lie on once, so that a bad one is an Error before anything is written. What of
/// it is not drawn, and at which height scales its prisms turn inside out, are warnings. What run.json has of it, an
/// array: name, base_fit, scale, vertices, triangles, charts, and the hash of the mesh as it is drawn; empty where no
/// cell lies on a file.
Json inspect_bases(const std::vector<Cell>& cells);

/// Of vertices and triangles.
std::string hash_of_mesh(const BaseMesh& mesh);

}  // namespace reliefbench
