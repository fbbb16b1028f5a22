#pragma once

#include "measure/shared_inputs.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"

#include <functional>
#include <span>
#include <string>

namespace reliefbench {

/// One cell of the view: a renderer that has been prepared, and the result that gets the figures of motion, or which
/// becomes failed, with the reason.
struct MotionSubject {
    Renderer* renderer = nullptr;
    CellResult* result = nullptr;
};

using GoesOn = std::function<bool(const std::string& cell)>;

/// Moves the camera of one view, frame by frame, and follows what the errors of all its cells do from each frame to the
/// next; with a history, also what that shows (measure/followed_history.hpp). Each frame's truth is traced once for as
/// many cells as 256 MiB of hits and histories allow; two of them are held at a time, beside the view's own.
/// `goes_on` is told the cell before each of its frames; false ends all at once, with nothing set. May be empty.
void measure_motion(SharedInputs& inputs, const ViewKey& view, const Configuration& configuration,
                    std::span<const MotionSubject> subjects, const GoesOn& goes_on);

}  // namespace reliefbench
