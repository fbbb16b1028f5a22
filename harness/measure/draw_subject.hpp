#pragma once

#include "measure/subject.hpp"
#include "sweep/configuration.hpp"

#include <functional>

namespace reliefbench {

/// Name of the draw among a cell's passes.
inline constexpr const char* draw_pass = "draw";

/// `samples` timings of `repeats` draws each, in milliseconds per draw: Renderer::time_draw, or a fake of it.
using TimeDraw = std::function<std::vector<double>(int samples, int repeats)>;

/// A cell's draw as the sampler visits it. Warming up also finds how many draws go into one timestamp pair so that
/// none is shorter than the settings' least duration.
class DrawSubject : public Subject {
public:
    DrawSubject(TimeDraw time_draw, const SamplingSettings& settings);

    void warm_up() override;
    std::map<std::string, std::vector<double>> visit(int count) override;

    int repeats() const { return repeats_; }

private:
    /// Milliseconds of all draws together.
    double draw_unrecorded(int samples, int repeats);

    TimeDraw time_draw_;
    SamplingSettings settings_;
    int repeats_ = 1;
};

}  // namespace reliefbench
