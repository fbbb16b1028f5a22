#pragma once

namespace reliefbench {

/// Wall time for progress and the time split; tests put a fake one in its place.
class Clock {
public:
    virtual ~Clock() = default;
    /// Monotonic, from an arbitrary origin.
    virtual double seconds() const = 0;
};

const Clock& steady_clock();

}  // namespace reliefbench
