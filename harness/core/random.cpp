#include "core/random.hpp"

#include <cassert>

namespace reliefbench {

namespace {

/// The odd integer nearest to 2^64 divided by the golden ratio: SplitMix64's increment.
constexpr std::uint64_t golden_increment = 0x9e3779b97f4a7c15;

/// The upper 53 bits as a number in [0, 1): every value is a double exactly.
double unit_interval(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace

std::uint64_t mix_bits(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

double random_at(std::uint64_t seed, std::int64_t x, std::int64_t y) {
    std::uint64_t bits = mix_bits(seed + golden_increment);
    bits = mix_bits(bits + golden_increment + static_cast<std::uint64_t>(x));
    bits = mix_bits(bits + golden_increment + static_cast<std::uint64_t>(y));
    return unit_interval(bits);
}

std::uint64_t Random::next() {
    state_ += golden_increment;
    return mix_bits(state_);
}

double Random::uniform() {
    return unit_interval(next());
}

std::uint64_t Random::below(std::uint64_t count) {
    assert(count > 0);
    // 2^64 mod count: numbers below it would make the first remainders too frequent.
    const std::uint64_t uneven = (0 - count) % count;
    for (;;) {
        const std::uint64_t bits = next();
        if (bits >= uneven) return bits % count;
    }
}

}  // namespace reliefbench
