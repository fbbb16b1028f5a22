#include "reference/maximum_mip_chain.hpp"

#include "core/parallel.hpp"

#include <algorithm>
#include <utility>

namespace reliefbench {
namespace {

using Level = MaximumMipChain::Level;

constexpr std::size_t rows_per_task = 32;

Level empty_level(int columns, int rows) {
    return {columns, rows, std::vector<float>(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))};
}

/// A node of two by two cells sees three by three texels.
Level first_level(const HeightMap& map) {
    const int width = map.width();
    const int height = map.height();
    Level level = empty_level((width + 1) / 2, (height + 1) / 2);
    const auto texel_row = [&](int row) {
        return map.heights.texels.data() + static_cast<std::size_t>(row % height) * static_cast<std::size_t>(width);
    };
    parallel_for(static_cast<std::size_t>(level.rows), rows_per_task, [&](std::size_t begin, std::size_t end) {
        std::vector<float> column_maxima(static_cast<std::size_t>(width) + 2);
        for (std::size_t row = begin; row < end; ++row) {
            const int first = 2 * static_cast<int>(row);
            const float* below = texel_row(first);
            const float* middle = texel_row(first + 1);
            const float* above = texel_row(std::min(first + 2, height));
            for (int x = 0; x < width; ++x) {
                column_maxima[x] = std::max(std::max(below[x], middle[x]), above[x]);
            }
            column_maxima[width] = column_maxima[0];
            column_maxima[width + 1] = column_maxima[0];
            float* maxima = level.maxima.data() + row * static_cast<std::size_t>(level.columns);
            for (int column = 0; column < level.columns; ++column) {
                const float* three = column_maxima.data() + 2 * column;
                maxima[column] = std::max(std::max(three[0], three[1]), three[2]);
            }
        }
    });
    return level;
}

Level next_level(const Level& finer) {
    Level level = empty_level((finer.columns + 1) / 2, (finer.rows + 1) / 2);
    for (int row = 0; row < level.rows; ++row) {
        const int upper = std::min(2 * row + 1, finer.rows - 1);
        for (int column = 0; column < level.columns; ++column) {
            const int right = std::min(2 * column + 1, finer.columns - 1);
            level.maxima[static_cast<std::size_t>(row) * level.columns + column] =
                std::max(std::max(finer.at(2 * column, 2 * row), finer.at(right, 2 * row)),
                         std::max(finer.at(2 * column, upper), finer.at(right, upper)));
        }
    }
    return level;
}

}  // namespace

MaximumMipChain::MaximumMipChain(const HeightMap& map) {
    levels_.push_back(first_level(map));
    while (levels_.back().columns > 1 || levels_.back().rows > 1) {
        levels_.push_back(next_level(levels_.back()));
    }
}

}  // namespace reliefbench
