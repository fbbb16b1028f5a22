#pragma once

#include "core/json.hpp"
#include "manifest/parameter.hpp"

#include <optional>

namespace reliefbench {

Json to_json(const ParameterValue& value);

/// The value as the parameter's type: a whole number does for a real parameter, and one written as 64.0 for an integer
/// one. A boolean, number or string of another type stays what it is, for check_parameter_value to refuse. Empty when
/// it is no scalar.
std::optional<ParameterValue> parameter_value_from_json(const Parameter& parameter, const Json& json);

/// The same, checked: a wrong type or a value out of range is an Error that names file and JSON path.
ParameterValue read_parameter_value(const Parameter& parameter, const JsonView& view);

}  // namespace reliefbench
