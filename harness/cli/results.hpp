#pragma once

#include <string_view>

namespace reliefbench {

/// To standard output. What cannot be written is found at the end of the program, for all of the output at once; fmt's
/// print would throw from the middle of it.
void print_results(std::string_view text);

}  // namespace reliefbench
