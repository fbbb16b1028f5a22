#pragma once

#include "reference/truth.hpp"

#include <string>
#include <string_view>

namespace reliefbench {

/// A truth as bytes, to be read again on this machine: one line of JSON ("format", "resolution", "samples",
/// "background", "light_standard_error", "with", "uniform"), and then the texels of its images. All of it but the time
/// it took.
std::string stored_truth(const Truth& truth);

/// The same truth, bit for bit; its time is 0. Throws Error for bytes that are no such truth.
Truth parse_stored_truth(std::string_view bytes);

}  // namespace reliefbench
