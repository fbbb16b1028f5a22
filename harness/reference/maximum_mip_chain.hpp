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
    explicit MaximumMipChain(const HeightMap& map);

    /// The top level is one node.
    int top_level() const { return static_cast<int>(levels_.size()) - 1; }

    /// 1 ≤ level ≤ top_level().
    float at(int level, int column, int row) const {
        const Level& nodes = levels_[static_cast<std::size_t>(level)];
        return maxima_[nodes.first + static_cast<std::size_t>(row) * nodes.columns + static_cast<std::size_t>(column)];
    }

private:
    struct Level {
        std::size_t first = 0;
        std::size_t columns = 0;
        std::size_t rows = 0;
    };

    void fill_first_level(const HeightMap& map);
    void fill_level(const Level& finer, const Level& level);

    std::vector<Level> levels_;
    std::vector<float> maxima_;
};

}  // namespace reliefbench
