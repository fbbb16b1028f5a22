#pragma once

#include "core/json.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// A "-a" argument.
struct Override {
    std::string name;
    std::vector<Json> values;
    /// As written: "-a view_angle=0,60"; what messages name instead of a file.
    std::string argument;
};

/// "name=v1,v2", "name=[start:stop:step]" (stop included when met), both mixed, or "name={...}", one JSON object.
/// An argument that is neither is an Error.
Override parse_override(const std::string& argument);

/// A word as JSON: a number, true or false where it reads as one, else a string.
Json scalar_from_text(const std::string& text);

/// "a,b,c" at its commas; those in brackets do not count.
std::vector<std::string> split_list(const std::string& text);

}  // namespace reliefbench
