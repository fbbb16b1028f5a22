#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/commands.hpp"
#include "gpu/recording.hpp"
#include "gpu/timers.hpp"
#include "technique/draw.hpp"

#include <cassert>
#include <cstdint>
#include <string>

namespace reliefbench {

/// The commands that time a draw.
struct TimedRecording {
    TimedRecording(const gpu::Device& device, const Draw& draw, const std::string& what, int samples_in_all,
                   int repeats_each)
        : samples(samples_in_all),
          repeats(repeats_each),
          timestamps(device, static_cast<std::uint32_t>(samples)),
          recording(
              device, what, [&](const vk::raii::CommandBuffer& commands) { record(commands, draw); },
              samples_in_all * repeats_each) {}

    void record(const vk::raii::CommandBuffer& commands, const Draw& draw) const {
        assert(samples > 0 && repeats > 0);
        timestamps.reset(commands);
        draw.begin(commands);
        for (int sample = 0; sample < samples; ++sample) {
            timestamps.start(commands, static_cast<std::uint32_t>(sample));
            for (int repeat = 0; repeat < repeats; ++repeat) {
                if (repeat > 0) gpu::full_barrier(commands);
                draw.record(commands);
            }
            timestamps.end(commands, static_cast<std::uint32_t>(sample));
        }
    }

    int samples;
    int repeats;
    gpu::Timestamps timestamps;
    gpu::Recording recording;
};

}  // namespace reliefbench
