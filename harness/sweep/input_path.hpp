#pragma once

#include "core/json.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// The path given, absolute, so that it means the same file wherever the configuration is read again: in the first of
/// `folders` that has it. An Error where none has; `neither` and `known` end its message where the value could have
/// been something else ("neither a procedural height map", "procedural are rock, ...").
std::string resolve_input_path(const JsonView& view, const std::vector<std::filesystem::path>& folders,
                               const std::string& neither = {}, const std::string& known = {});

}  // namespace reliefbench
