#include "technique/slice_plan.hpp"

#include "core/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace reliefbench {

namespace {

/// lavapipe (Mesa 22.3) silently ends all loops of an invocation together after 65,535 iterations.
constexpr std::int64_t max_iterations = 60000;
/// Far below the seconds after which a desktop takes a device for hung.
constexpr double target_ms = 100;
/// Iterations of all invocations together in the first slice, whose cost nobody knows: some ten milliseconds on a CPU
/// device.
constexpr std::int64_t first_iterations = std::int64_t{1} << 22;
/// A slice may be so many times as long as the one before.
constexpr double largest_growth = 4;
/// A slice is of full length from here on.
constexpr double full_ms = target_ms / 2;
constexpr std::size_t sound_slices = 5;
constexpr double sound_ms = 500;
/// Two seconds of them.
constexpr std::size_t remembered_slices = 20;
constexpr double unloaded_quantile = 0.25;

}  // namespace

SlicePlan::SlicePlan(std::int64_t sources, std::int64_t invocations, int iterations)
    : sources_(sources),
      most_(std::max<std::int64_t>(max_iterations / iterations, 1)),
      length_(std::clamp<std::int64_t>(first_iterations / (invocations * iterations), 1, most_)) {
    assert(sources > 0 && invocations > 0 && iterations > 0);
}

Slice SlicePlan::next() const {
    return {done_, std::min(done_ + length_, sources_)};
}

void SlicePlan::took(double milliseconds) {
    const Slice slice = next();
    const auto length = static_cast<double>(slice.end - slice.begin);
    const bool is_full = milliseconds >= full_ms || slice.end - slice.begin == most_;
    done_ = slice.end;
    ++slices_;
    elapsed_ms_ += milliseconds;
    last_ms_per_source_ = milliseconds / length;
    if (is_full) full_ms_per_source_.push_back(last_ms_per_source_);
    if (full_ms_per_source_.size() > remembered_slices) full_ms_per_source_.pop_front();
    const double growth = milliseconds > 0 ? std::min(target_ms / milliseconds, largest_growth) : largest_growth;
    length_ = std::clamp<std::int64_t>(std::llround(growth * length), 1, most_);
}

double SlicePlan::estimated_ms() const {
    const double ms_per_source =
        full_ms_per_source_.empty()
            ? last_ms_per_source_
            : quantile(std::vector(full_ms_per_source_.begin(), full_ms_per_source_.end()), unloaded_quantile);
    return elapsed_ms_ + ms_per_source * static_cast<double>(sources_ - done_);
}

bool SlicePlan::is_estimate_sound() const {
    return full_ms_per_source_.size() >= sound_slices && elapsed_ms_ >= sound_ms;
}

}  // namespace reliefbench
