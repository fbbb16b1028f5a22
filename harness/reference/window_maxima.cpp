#include "reference/window_maxima.hpp"

#include "core/parallel.hpp"

#include <algorithm>
#include <bit>
#include <vector>

namespace reliefbench {

namespace {

constexpr std::size_t window_rows_per_task = 32;

/// At least WindowMaxima::margin above the height, which is in [0, 1].
std::uint16_t bound_of(float height) {
    return static_cast<std::uint16_t>(static_cast<int>(height * 65533.0F + 2.0F));
}

std::size_t windows_along(std::size_t cells, int level) {
    return (cells + (std::size_t{1} << level) - 1) >> level;
}

}  // namespace

WindowMaxima::WindowMaxima(const HeightMap& map) {
    const auto width = static_cast<std::size_t>(map.width());
    const auto height = static_cast<std::size_t>(map.height());
    const std::size_t columns = std::bit_ceil(width);
    const std::size_t rows = std::bit_ceil(height);
    row_shift_ = std::countr_zero(columns);
    top_level_ = static_cast<int>(std::bit_width(std::min(columns, rows))) - 1;
    // Level 0 has so many windows, and all coarser ones lie before it.
    first_ = columns * rows;
    bounds_ = std::make_unique_for_overwrite<std::uint16_t[]>(2 * first_ + 1);
    fill_first_level(map);
    for (int level = 1; level <= top_level_; ++level)
        fill_level(level, width, height);
}

/// A window of two by two cells sees three by three texels.
void WindowMaxima::fill_first_level(const HeightMap& map) {
    const auto width = static_cast<std::size_t>(map.width());
    const auto height = static_cast<std::size_t>(map.height());
    const auto texel_row = [&](std::size_t row) { return map.heights.texels.data() + (row % height) * width; };
    parallel_for(height, window_rows_per_task, [&](std::size_t begin, std::size_t end) {
        std::vector<float> column_maxima(width + 2);
        for (std::size_t row = begin; row < end; ++row) {
            const float* lower = texel_row(row);
            const float* middle = texel_row(row + 1);
            const float* upper = texel_row(row + 2);
            for (std::size_t x = 0; x < width; ++x)
                column_maxima[x] = std::max(std::max(lower[x], middle[x]), upper[x]);
            column_maxima[width] = column_maxima[0];
            column_maxima[width + 1] = column_maxima[1 % width];
            std::uint16_t* out = bounds_.get() + index(0, 0, row);
            for (std::size_t x = 0; x < width; ++x) {
                const float* three = column_maxima.data() + x;
                out[x] = bound_of(std::max(std::max(three[0], three[1]), three[2]));
            }
        }
    });
}

/// A window is four of the finer level, side by side.
void WindowMaxima::fill_level(int level, std::size_t width, std::size_t height) {
    const std::size_t finer_columns = windows_along(width, level - 1);
    const std::size_t finer_rows = windows_along(height, level - 1);
    const std::size_t columns = windows_along(width, level);
    const std::size_t rows = windows_along(height, level);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::uint16_t* lower = bounds_.get() + index(level - 1, 0, 2 * row);
        const std::uint16_t* upper =
            bounds_.get() + index(level - 1, 0, 2 * row + 2 < finer_rows ? 2 * row + 2 : 2 * row);
        std::uint16_t* out = bounds_.get() + index(level, 0, row);
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t left = 2 * column;
            const std::size_t right = left + 2 < finer_columns ? left + 2 : left;
            out[column] = std::max(std::max(lower[left], lower[right]), std::max(upper[left], upper[right]));
        }
    }
}

}  // namespace reliefbench
