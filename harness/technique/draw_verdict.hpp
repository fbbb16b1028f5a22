#pragma once

#include "technique/renderer.hpp"

#include <optional>
#include <string>

namespace reliefbench {

/// Whether what was drawn is the technique's picture: `run`, `ab`, `bench`, `render` and `verify` all ask here.
struct DrawVerdict {
    /// Why it is not, with what to do; empty where it is.
    std::string reason;
    /// Nothing of the draw means anything: the technique answered out of range. What else fails a draw leaves figures
    /// that show it.
    bool is_meaningless = false;
    /// Of answers out of range, where the worst is one of a pixel.
    std::optional<PixelPlace> worst = {};
};

/// In this order: answers out of range, loops that the device ended, more than half of the covered pixels unconverged.
DrawVerdict judge_draw(const gpu::Device& device, const Manifest& manifest, const ParameterValues& parameters,
                       const Probe& probe);

}  // namespace reliefbench
