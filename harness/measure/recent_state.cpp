#include "measure/recent_state.hpp"

namespace reliefbench {

namespace {

constexpr double longest_age_s = 0.05;

}  // namespace

RecentState::RecentState(gpu::DeviceStateSource& source, const Clock& clock) : source_(&source), clock_(&clock) {}

const gpu::DeviceState& RecentState::read() {
    const double now_s = clock_->seconds();
    if (!was_read_ || now_s - read_at_s_ >= longest_age_s) {
        state_ = source_->read();
        read_at_s_ = now_s;
        was_read_ = true;
    }
    return state_;
}

}  // namespace reliefbench
