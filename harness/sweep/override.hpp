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

/// "name=<values>", values as parse_values takes them, given to an option, which messages name. An argument that is
/// none is an Error.
Override parse_override(const std::string& argument, const std::string& option = "-a");

/// The values that the command line gives for `name`, separated by commas. Each is
/// - a word: a number, true or false where it reads as one, else a string (always, of a technique or a height map);
/// - a range [start:stop:step], its stop included when met;
/// - JSON: "a string", {an object}, or [an array] of values. So are values written that have commas or brackets.
/// `argument` is for messages.
std::vector<Json> parse_values(const std::string& name, const std::string& text, const std::string& argument);

/// A word as JSON: a number, true or false where it reads as one, else a string.
Json scalar_from_text(const std::string& text);

}  // namespace reliefbench
