#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace reliefbench {

/// "1 cell", "2 cells"; of a noun whose plural takes an s.
std::string counted(std::size_t count, std::string_view noun);

}  // namespace reliefbench
