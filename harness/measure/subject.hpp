#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// What the sampler visits: a cell that can be timed. The runner is tested with a fake one.
class Subject {
public:
    /// Milliseconds by pass, of one draw each.
    using Samples = std::map<std::string, std::vector<double>>;

    virtual ~Subject() = default;

    /// Draws until timings are stationary, without recording.
    virtual void warm_up() = 0;

    /// `count` samples in milliseconds of each pass timed at a visit.
    virtual Samples visit(int count) = 0;

    /// A visit in two halves, so that the host can do other things while the device is at it. One visit at a time. A
    /// subject that cannot be split is visited when it is submitted.
    virtual void submit(int count) { visited_ = visit(count); }
    virtual Samples collect() { return std::exchange(visited_, {}); }

    /// Draws inside one timestamp pair.
    virtual int repeats() const { return 1; }

private:
    Samples visited_;
};

}  // namespace reliefbench
