#pragma once

#include "measure/subject.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"

#include <functional>
#include <vector>

namespace reliefbench {

/// `samples` timings of `repeats` draws each, in milliseconds per draw: Renderer::time_draw, or a fake of it.
using TimeDraw = std::function<std::vector<double>(int samples, int repeats)>;

/// The same in two halves: Renderer::submit_draw and collect_draw.
struct DrawTimer {
    std::function<void(int samples, int repeats)> submit;
    std::function<std::vector<double>()> collect;
};

/// The renderer must stay where it is for as long.
DrawTimer timer_of(Renderer& renderer);

/// A cell's draw as the sampler visits it. Warming up lasts until the first-use compilation of the driver is over and
/// timings no longer fall, and finds how many draws go into one timestamp pair so that none is shorter than the
/// settings' least duration.
class DrawSubject : public Subject {
public:
    DrawSubject(DrawTimer timer, const SamplingSettings& settings);
    DrawSubject(TimeDraw time_draw, const SamplingSettings& settings);

    void warm_up() override;
    Samples visit(int count) override;
    void submit(int count) override;
    Samples collect() override;
    int repeats() const override { return repeats_; }

private:
    double find_repeats();
    std::vector<double> draw_unrecorded(int samples, int repeats);

    DrawTimer timer_;
    SamplingSettings settings_;
    int repeats_ = 1;
    double warm_up_ms_ = 0;
};

}  // namespace reliefbench
