#pragma once

#include <string>

namespace reliefbench {

/// A fraction written as "2%" or "0.02", above 0 and below 1. What is neither, or out of range, is an Error that names
/// `option`.
double parse_threshold(const std::string& text, const std::string& option);

}  // namespace reliefbench
