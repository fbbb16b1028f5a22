#pragma once

#include "core/json.hpp"
#include "manifest/manifest.hpp"

#include <string>

namespace reliefbench {

/// What of technique.json refers to parameters; a name that there is not is an Error with a "did you mean".

/// The name of an integer parameter.
std::string parse_integer_name(const JsonView& view, const Manifest& manifest);

/// Values of some of the parameters.
ParameterValues parse_values(const JsonView& view, const Manifest& manifest);

}  // namespace reliefbench
