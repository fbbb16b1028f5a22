#pragma once

#include "store/run_folder.hpp"

#include <string>

namespace reliefbench {

/// What github-action-benchmark reads as `customSmallerIsBetter`: the draw's median of each measured cell with its MAD
/// as the range, and the interval, the taps and the UV error in words.
std::string format_github_action(const Run& run);

}  // namespace reliefbench
