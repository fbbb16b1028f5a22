#pragma once

#include <cstdint>
#include <span>
#include <utility>

namespace reliefbench {

/// Mixes 64 bits (the finaliser of SplitMix64, Steele et al. 2014): a stateless, seedable hash of integers.
std::uint64_t mix_bits(std::uint64_t bits);

/// A hash of (seed, x, y) as a number in [0, 1): the same on every machine, which standard distributions are not.
double random_at(std::uint64_t seed, std::int64_t x, std::int64_t y);

/// A seeded sequence (SplitMix64), the same on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next();
    /// In [0, 1).
    double uniform();
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// In [0, count); count > 0.
    std::uint64_t below(std::uint64_t count);

    template <typename Value>
    void shuffle(std::span<Value> values) {
        for (std::size_t remaining = values.size(); remaining > 1; --remaining) {
            using std::swap;
            swap(values[remaining - 1], values[below(remaining)]);
        }
    }

private:
    std::uint64_t state_;
};

}  // namespace reliefbench
