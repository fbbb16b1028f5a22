#pragma once

#include "gpu/device_state.hpp"
#include "measure/clock.hpp"

namespace reliefbench {

/// A device's state, read anew only when the last reading is 50 ms old: asking the driver takes as long as a short
/// visit, and neither clocks nor heat change faster.
class RecentState {
public:
    /// Both must outlive it.
    RecentState(gpu::DeviceStateSource& source, const Clock& clock);

    const gpu::DeviceState& read();
    bool is_throttled() { return read().throttled.value_or(false); }

private:
    gpu::DeviceStateSource* source_;
    const Clock* clock_;
    gpu::DeviceState state_;
    double read_at_s_ = 0;
    bool was_read_ = false;
};

}  // namespace reliefbench
