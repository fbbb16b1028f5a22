#pragma once

#include "scene/height_map.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace reliefbench {

/// Upper bounds of the bilinear surface over overlapping windows of cells (cells as in MaximumMipChain). Window (i, j)
/// of level k covers the 2^(k+1) × 2^(k+1) cells from cell (i·2^k, j·2^k) on, as far as the map goes. So whatever lies
/// within 2^k cells of a point, to one side of it, is in the window that the point lies in the first quarter of: one
/// bound for a step of 2^k cells from anywhere, whatever the direction. Quantised, upwards, to 16 bits.
class WindowMaxima {
public:
    explicit WindowMaxima(const HeightMap& map);

    /// Its windows are half as wide as the map's shorter side, at least.
    int top_level() const { return top_level_; }

    /// Window (i, j) of level k is bounds()[index(k, i, j)], in steps of `step`; one more element may be read behind
    /// the last.
    const std::uint16_t* bounds() const { return bounds_.get(); }
    /// So that of all levels' indices none needs a table: (first_ >> 2k) + (j << (row_shift_ − k)) + i.
    std::size_t index(int level, std::size_t column, std::size_t row) const {
        return (first_ >> (2 * level)) + (row << (row_shift_ - level)) + column;
    }
    std::size_t first() const { return first_; }
    int row_shift() const { return row_shift_; }

    /// By this much at least a bound lies above the surface.
    static constexpr double margin = 1e-5;
    static constexpr double step = 1.0 / 65533;

private:
    void fill_first_level(const HeightMap& map);
    void fill_level(int level, std::size_t width, std::size_t height);

    int top_level_ = 0;
    int row_shift_ = 0;
    std::size_t first_ = 0;
    /// Not initialised: between the levels there are gaps that nobody touches.
    std::unique_ptr<std::uint16_t[]> bounds_;
};

}  // namespace reliefbench
