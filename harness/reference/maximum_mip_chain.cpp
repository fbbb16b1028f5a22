#include "reference/maximum_mip_chain.hpp"

#include "core/parallel.hpp"

#include <algorithm>

namespace reliefbench {

MaximumMipChain::MaximumMipChain(const HeightMap& map) {
    Level level{0, static_cast<std::size_t>(map.width()), static_cast<std::size_t>(map.height())};
    levels_.push_back(level);
    std::size_t nodes = 0;
    do {
        level = {nodes, (level.columns + 1) / 2, (level.rows + 1) / 2};
        levels_.push_back(level);
        nodes += level.columns * level.rows;
    } while (level.columns > 1 || level.rows > 1);
    maxima_.resize(nodes);

    fill_first_level(map);
    for (std::size_t k = 2; k < levels_.size(); ++k) {
        fill_level(levels_[k - 1], levels_[k]);
    }
}

/// A node of two by two cells sees three by three texels.
void MaximumMipChain::fill_first_level(const HeightMap& map) {
    const Level& cells = levels_[0];
    const Level& level = levels_[1];
    const auto texel_row = [&](std::size_t row) {
        return map.heights.texels.data() + (row % cells.rows) * cells.columns;
    };
    constexpr std::size_t rows_per_task = 32;
    parallel_for(level.rows, rows_per_task, [&](std::size_t begin, std::size_t end) {
        std::vector<float> column_maxima(cells.columns + 2);
        for (std::size_t row = begin; row < end; ++row) {
            const float* lower = texel_row(2 * row);
            const float* middle = texel_row(2 * row + 1);
            const float* upper = texel_row(std::min(2 * row + 2, cells.rows));
            for (std::size_t x = 0; x < cells.columns; ++x) {
                column_maxima[x] = std::max(std::max(lower[x], middle[x]), upper[x]);
            }
            column_maxima[cells.columns] = column_maxima[0];
            column_maxima[cells.columns + 1] = column_maxima[0];
            float* out = maxima_.data() + level.first + row * level.columns;
            for (std::size_t column = 0; column < level.columns; ++column) {
                const float* three = column_maxima.data() + 2 * column;
                out[column] = std::max(std::max(three[0], three[1]), three[2]);
            }
        }
    });
}

void MaximumMipChain::fill_level(const Level& finer, const Level& level) {
    for (std::size_t row = 0; row < level.rows; ++row) {
        const float* lower = maxima_.data() + finer.first + 2 * row * finer.columns;
        const float* upper = maxima_.data() + finer.first + std::min(2 * row + 1, finer.rows - 1) * finer.columns;
        float* out = maxima_.data() + level.first + row * level.columns;
        for (std::size_t column = 0; column < level.columns; ++column) {
            const std::size_t left = 2 * column;
            const std::size_t right = std::min(left + 1, finer.columns - 1);
            out[column] = std::max(std::max(lower[left], lower[right]), std::max(upper[left], upper[right]));
        }
    }
}

}  // namespace reliefbench
