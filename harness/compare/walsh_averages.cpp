#include "compare/walsh_averages.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cassert>

namespace reliefbench {

WalshAverages::WalshAverages(std::span<const double> values) : sorted_(values.begin(), values.end()) {
    std::sort(sorted_.begin(), sorted_.end());
}

double WalshAverages::nth(std::size_t index) const {
    assert(index < count());
    const std::size_t size = sorted_.size();
    // Row i holds the averages with columns i, i+1, ..., ascending. Those that may still be the one looked for are in
    // columns begin[i] to end[i] - 1.
    std::vector<std::size_t> begin(size);
    std::vector<std::size_t> end(size, size);
    for (std::size_t row = 0; row < size; ++row) {
        begin[row] = row;
    }
    std::vector<std::size_t> below(size);
    std::vector<std::size_t> not_above(size);
    std::size_t left = count();
    Random random(1);
    for (;;) {
        std::size_t chosen = random.below(left);
        std::size_t chosen_row = 0;
        while (chosen >= end[chosen_row] - begin[chosen_row]) {
            chosen -= end[chosen_row] - begin[chosen_row];
            ++chosen_row;
        }
        const double pivot = average(chosen_row, begin[chosen_row] + chosen);

        // The columns' ends move left as rows go down.
        std::size_t count_below = 0;
        std::size_t count_not_above = 0;
        std::size_t end_below = size;
        std::size_t end_not_above = size;
        for (std::size_t row = 0; row < size; ++row) {
            while (end_below > row && average(row, end_below - 1) >= pivot) {
                --end_below;
            }
            while (end_not_above > row && average(row, end_not_above - 1) > pivot) {
                --end_not_above;
            }
            below[row] = std::max(end_below, row);
            not_above[row] = std::max(end_not_above, row);
            count_below += below[row] - row;
            count_not_above += not_above[row] - row;
        }
        if (index >= count_below && index < count_not_above) return pivot;

        left = 0;
        for (std::size_t row = 0; row < size; ++row) {
            if (index < count_below) {
                end[row] = std::clamp(below[row], begin[row], end[row]);
            } else {
                begin[row] = std::clamp(not_above[row], begin[row], end[row]);
            }
            left += end[row] - begin[row];
        }
    }
}

}  // namespace reliefbench
