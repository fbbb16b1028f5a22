#pragma once

#include "cli/command_tree.hpp"

#include <string>

namespace reliefbench {

/// The manual page in roff with man(7)'s macros, written from the command line's own help.
std::string man_page(const CommandDescription& program, const std::string& version);

}  // namespace reliefbench
