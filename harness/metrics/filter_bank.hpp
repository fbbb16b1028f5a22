#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <vector>

namespace reliefbench {

/// `Even` even kernels and `Odd` odd ones, in this order, that read the same input: taps 0 … radius of each.
template <std::size_t Even, std::size_t Odd>
struct FilterBank {
    std::vector<std::array<float, Even + Odd>> taps;
};

/// Rows are filtered in pieces of so many columns: their lengths must be a multiple of it.
constexpr std::size_t filter_columns = 8;

/// out[kernel][x] = Σ kernel[tap] · at(tap)[x] over the taps −radius … radius, for x in [0, width). Loads, and the sums
/// of mirrored taps, are shared by the kernels; the accumulators of a few columns stay in registers.
template <std::size_t Even, std::size_t Odd, typename At>
void apply(const FilterBank<Even, Odd>& bank, const At& at, std::size_t width,
           const std::array<float*, Even + Odd>& out) {
    assert(width % filter_columns == 0 && !bank.taps.empty());
    using Columns = std::array<float, filter_columns>;
    const auto radius = static_cast<std::ptrdiff_t>(bank.taps.size()) - 1;
    for (std::size_t x = 0; x < width; x += filter_columns) {
        std::array<Columns, Even + Odd> sums{};
        const float* const centre = at(0) + x;
        for (std::size_t kernel = 0; kernel < Even; ++kernel) {
            for (std::size_t i = 0; i < filter_columns; ++i) {
                sums[kernel][i] = bank.taps[0][kernel] * centre[i];
            }
        }
        for (std::ptrdiff_t tap = 1; tap <= radius; ++tap) {
            const float* const before = at(-tap) + x;
            const float* const after = at(tap) + x;
            Columns sum;
            Columns difference;
            for (std::size_t i = 0; i < filter_columns; ++i) {
                sum[i] = after[i] + before[i];
                difference[i] = after[i] - before[i];
            }
            const std::array<float, Even + Odd>& weights = bank.taps[static_cast<std::size_t>(tap)];
            for (std::size_t kernel = 0; kernel < Even + Odd; ++kernel) {
                for (std::size_t i = 0; i < filter_columns; ++i) {
                    sums[kernel][i] += weights[kernel] * (kernel < Even ? sum[i] : difference[i]);
                }
            }
        }
        for (std::size_t kernel = 0; kernel < Even + Odd; ++kernel) {
            std::copy(sums[kernel].begin(), sums[kernel].end(), out[kernel] + x);
        }
    }
}

}  // namespace reliefbench
