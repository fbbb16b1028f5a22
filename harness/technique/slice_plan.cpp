#include "technique/slice_plan.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

/// lavapipe (Mesa 22.3) silently ends all loops of an invocation together after 65,535 iterations.
constexpr std::int64_t most_iterations = 60000;
/// Far below the seconds after which a desktop takes a device for hung.
constexpr double target_ms = 100;
/// Iterations of all invocations together in the first slice, whose cost nobody knows: some ten milliseconds on a CPU
/// device.
constexpr std::int64_t first_iterations = std::int64_t{1} << 22;
/// A slice may be so many times as long as the one before.
constexpr double largest_growth = 4;
constexpr int sound_slices = 3;
constexpr double sound_ms = 500;

}  // namespace

SlicePlan::SlicePlan(std::int64_t sources, std::int64_t invocations, int iterations)
    : sources_(sources),
      most_(std::max<std::int64_t>(most_iterations / iterations, 1)),
      length_(std::clamp<std::int64_t>(first_iterations / (invocations * iterations), 1, most_)) {
    assert(sources > 0 && invocations > 0 && iterations > 0);
}

Slice SlicePlan::next() const {
    return {done_, std::min(done_ + length_, sources_)};
}

void SlicePlan::took(double milliseconds) {
    const Slice slice = next();
    const auto length = static_cast<double>(slice.end - slice.begin);
    done_ = slice.end;
    ++slices_;
    elapsed_ms_ += milliseconds;
    last_ms_per_source_ = milliseconds / length;
    const double growth = milliseconds > 0 ? std::min(target_ms / milliseconds, largest_growth) : largest_growth;
    length_ = std::clamp<std::int64_t>(std::llround(growth * length), 1, most_);
}

double SlicePlan::estimated_ms() const {
    return elapsed_ms_ + last_ms_per_source_ * static_cast<double>(sources_ - done_);
}

bool SlicePlan::is_estimate_sound() const {
    return slices_ >= sound_slices && elapsed_ms_ >= sound_ms;
}

}  // namespace reliefbench
