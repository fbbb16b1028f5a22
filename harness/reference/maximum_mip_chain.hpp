#pragma once

#include "scene/height_map.hpp"

#include <vector>

namespace reliefbench {

/// Maxima of the bilinear surface over square blocks of cells. Cell (i, j) spans the texel centres (i, j) to
/// (i + 1, j + 1), repeating, so there are as many cells as texels. A node of level k ≥ 1 covers 2^k × 2^k cells; the
/// last node of a row or column is cut short by the map's size. Level 0, the cells, is not stored: a cell's maximum is
/// that of its four texels.
class MaximumMipChain {
public:
    struct Level {
        int columns = 0;
        int rows = 0;
        std::vector<float> maxima;

        float at(int column, int row) const { return maxima[static_cast<std::size_t>(row) * columns + column]; }
    };

    explicit MaximumMipChain(const HeightMap& map);

    /// 1 ≤ k ≤ top_level(); the top level is one node.
    const Level& level(int k) const { return levels_[static_cast<std::size_t>(k) - 1]; }
    int top_level() const { return static_cast<int>(levels_.size()); }

private:
    std::vector<Level> levels_;
};

}  // namespace reliefbench
