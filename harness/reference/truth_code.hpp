#pragma once

#include <string_view>

namespace reliefbench {

/// Identifies the code that traces: a hash over the sources of core, scene and reference, their compiler and its flags,
/// made when they are built (harness/truth_code.cmake). Truths that another code has traced may differ.
std::string_view truth_code();

}  // namespace reliefbench
