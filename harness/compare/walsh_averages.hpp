#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace reliefbench {

/// The n(n+1)/2 averages (x_i + x_j) / 2, i <= j, of n values, in ascending order, without ever making them all.
class WalshAverages {
public:
    explicit WalshAverages(std::span<const double> values);

    std::size_t count() const { return sorted_.size() * (sorted_.size() + 1) / 2; }

    /// The index-th smallest, from 0: by random pivots in the sorted matrix of averages (Monahan 1984), in O(n log n)
    /// expected time.
    double nth(std::size_t index) const;

private:
    double average(std::size_t row, std::size_t column) const { return (sorted_[row] + sorted_[column]) / 2; }

    std::vector<double> sorted_;
};

}  // namespace reliefbench
