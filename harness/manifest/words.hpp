#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// The words of a text between single spaces: long lists of names read better so.
std::vector<std::string> words(std::string_view text);

}  // namespace reliefbench
