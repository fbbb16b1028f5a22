#pragma once

#include "technique/renderer.hpp"
#include "technique/technique.hpp"

#include <functional>
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
    /// Figures: what was measured and what the bound was. For a failure also what to look at.
    std::string detail;
};

/// Runs the general checks (compiles, timed and probed agree, finite, closed forms on constant maps) and those of the
/// promises in the manifest. A shader that does not compile is a failed check, not an Error.
std::vector<Check> verify_technique(const gpu::Device& device, const Technique& technique,
                                    const std::function<void(const Check&)>& on_check = {},
                                    const PreparationSettings& preparation = {});

}  // namespace reliefbench
