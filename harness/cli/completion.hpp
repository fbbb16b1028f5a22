#pragma once

#include "cli/command_tree.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Scripts that complete commands, options and what options take: choices, files, folders, and by asking the program
/// itself the ids of techniques and the names of height maps. `axes` complete NAME=VALUES and EXPR.
std::string bash_completion(const CommandDescription& program, const std::vector<std::string>& axes);
std::string zsh_completion(const CommandDescription& program, const std::vector<std::string>& axes);

}  // namespace reliefbench
