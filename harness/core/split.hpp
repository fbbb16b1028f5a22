#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// The parts between separators, empty ones included: one more than there are separators.
std::vector<std::string> split(std::string_view text, char separator);

}  // namespace reliefbench
