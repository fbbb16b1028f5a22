#pragma once

#include "scene/height_map.hpp"
#include "scene/relief.hpp"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace reliefbench {

using Vertex = std::array<float, 3>;

/// The vertices of a displaced mesh: on texel centres and `subdivision` − 1 points between, in rows along u.
struct VertexGrid {
    /// The texel centre at the first vertex; texel indices repeat.
    int first_column = 0;
    int first_row = 0;
    int columns = 0;
    int rows = 0;
    int subdivision = 1;

    std::size_t vertices() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/// The smallest grid that encloses the patch coordinates from `low` to `high`; for the unit square, one texel past each
/// border. An Error if that is more than a mesh can have.
VertexGrid enclosing_grid(const HeightMap& map, const Relief& relief, glm::dvec2 low, glm::dvec2 high, int subdivision);

/// World positions of the grid's vertices on the bilinear surface.
void displace(const HeightMap& map, const Relief& relief, const VertexGrid& grid, std::span<Vertex> vertices);

}  // namespace reliefbench
