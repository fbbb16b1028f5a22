#pragma once

#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// What the sampler visits: a cell that can be timed. The runner is tested with a fake one.
class Subject {
public:
    virtual ~Subject() = default;

    /// Draws until the first-use compilation of the driver is over, without recording.
    virtual void warm_up() = 0;

    /// `count` samples in milliseconds of each pass timed at a visit.
    virtual std::map<std::string, std::vector<double>> visit(int count) = 0;
};

}  // namespace reliefbench
