#pragma once

#include "scene/pixel_place.hpp"
#include "technique/renderer.hpp"
#include "technique/technique.hpp"
#include "verify/circumstance.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

namespace gpu {
class Device;
}

/// The outcome of one conformance check of one technique.
struct Check {
    std::string technique;
    /// What is promised: "timed and probed agree", "first_hit", "order_1", ...
    std::string name;
    /// Under which parameters, map and angle.
    std::string circumstances;
    bool passed = false;
    /// Neither passed nor failed: a run would skip such a cell.
    bool skipped = false;
    /// Figures: what was measured and what the bound was. For a failure also what to look at.
    std::string detail;
    /// What was drawn; of several draws the one that fails, with its worst pixel where one can be named.
    struct Drawn {
        ParameterValues parameters;
        Circumstance where;
        std::optional<PixelPlace> worst = {};
    };
    std::optional<Drawn> drawn = {};

    bool failed() const { return !passed && !skipped; }
};

/// The words of the command line that shows what a check drew, from "render" on, without options of technique
/// directories and of the device.
std::vector<std::string> render_words(const Manifest& manifest, const Check::Drawn& drawn, const std::string& output);

/// The shell command that makes the map that the former name; empty where that is a procedural one.
std::string map_making_command(const Check::Drawn& drawn);

/// Runs the general checks (compiles, timed and probed agree, finite, closed forms on constant maps) and those of the
/// promises in the manifest. A shader that does not compile is a failed check, not an Error. What a run would call
/// skipped or failed is so here, with the same words: nothing is judged by a picture that is not the technique's.
std::vector<Check> verify_technique(const gpu::Device& device, const Technique& technique,
                                    const std::function<void(const Check&)>& on_check = {},
                                    const PreparationSettings& preparation = {});

}  // namespace reliefbench
