#include "scene/void_and_cluster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// Of the texels, those that the first pattern has, which may be any up to half.
constexpr int texels_per_first_point = 10;

/// Some of a square's texels, which wraps around, with how closely each texel lies to them.
class PointPattern {
public:
    PointPattern(int side, double sigma) : side_(side), points_(count(), 0), energy_(count(), 0) {
        for (int y = -reach(); y <= reach(); ++y) {
            for (int x = -reach(); x <= reach(); ++x) {
                const double distance_squared = double(x) * x + double(y) * y;
                weights_.push_back(std::llround(unit * std::exp(-distance_squared / (2 * sigma * sigma))));
            }
        }
    }

    std::size_t count() const { return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_); }

    void set(std::size_t texel, bool is_point) {
        assert((points_[texel] != 0) != is_point);
        points_[texel] = is_point ? 1 : 0;
        const int column = static_cast<int>(texel) % side_;
        const int row = static_cast<int>(texel) / side_;
        const std::int64_t sign = is_point ? 1 : -1;
        auto weight = weights_.begin();
        for (int y = -reach(); y <= reach(); ++y) {
            const int at_row = (row + y + 2 * side_) % side_ * side_;
            for (int x = -reach(); x <= reach(); ++x, ++weight)
                energy_[static_cast<std::size_t>(at_row + (column + x + 2 * side_) % side_)] += sign * *weight;
        }
    }

    /// The point that lies closest to the others; of several that do, the first in `order`.
    std::size_t tightest_cluster(const std::vector<std::size_t>& order) const {
        std::size_t best = 0;
        std::int64_t highest = -1;
        for (const std::size_t texel : order) {
            if (points_[texel] == 0 || energy_[texel] <= highest) continue;
            highest = energy_[texel];
            best = texel;
        }
        return best;
    }

    /// The texel farthest from all points.
    std::size_t largest_void(const std::vector<std::size_t>& order) const {
        std::size_t best = 0;
        std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
        for (const std::size_t texel : order) {
            if (points_[texel] != 0 || energy_[texel] >= lowest) continue;
            lowest = energy_[texel];
            best = texel;
        }
        return best;
    }

private:
    /// Sums of whole numbers are the same in any order and on any machine.
    static constexpr double unit = 0x1p40;

    /// Texels; beyond it a point's weight is nothing, or met from the other side.
    int reach() const { return std::min(12, (side_ - 1) / 2); }

    int side_;
    std::vector<std::uint8_t> points_;
    std::vector<std::int64_t> energy_;
    /// Of the texels around a point, row by row.
    std::vector<std::int64_t> weights_;
};

/// Which of equals comes first: without a direction that would show. std::shuffle is not the same everywhere.
std::vector<std::size_t> shuffled(std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 random(1993);
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    return order;
}

}  // namespace

Image<std::uint16_t> void_and_cluster(int side, double sigma) {
    assert(side >= 4 && side <= 256 && sigma > 0);
    PointPattern pattern(side, sigma);
    const std::vector<std::size_t> order = shuffled(pattern.count());
    const std::size_t first_points = pattern.count() / texels_per_first_point;
    for (std::size_t i = 0; i < first_points; ++i)
        pattern.set(order[i], true);
    // Points move from clusters into voids, until one would move back.
    for (std::size_t moved = 0;;) {
        const std::size_t cluster = pattern.tightest_cluster(order);
        pattern.set(cluster, false);
        const std::size_t empty = pattern.largest_void(order);
        pattern.set(empty, true);
        // No energy comes twice but among equals.
        if (empty == cluster || ++moved == pattern.count()) break;
    }

    Image<std::uint16_t> ranks({side, side});
    PointPattern fewer = pattern;
    for (std::size_t rank = first_points; rank-- > 0;) {
        const std::size_t texel = fewer.tightest_cluster(order);
        fewer.set(texel, false);
        ranks.texels[texel] = static_cast<std::uint16_t>(rank);
    }
    // Past the half what is left is the minority, whose tightest cluster is the largest void of the points.
    for (std::size_t rank = first_points; rank < pattern.count(); ++rank) {
        const std::size_t texel = pattern.largest_void(order);
        pattern.set(texel, true);
        ranks.texels[texel] = static_cast<std::uint16_t>(rank);
    }
    return ranks;
}

}  // namespace reliefbench
