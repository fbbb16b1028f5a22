#include "manifest/parameter_json.hpp"

#include <cmath>

namespace reliefbench {

Json to_json(const ParameterValue& value) {
    return std::visit([](const auto& held) { return Json(held); }, value);
}

std::optional<ParameterValue> parameter_value_from_json(const Parameter& parameter, const Json& json) {
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_string()) return json.get<std::string>();
    if (json.is_number_integer()) {
        // An unsigned number beyond the signed range must not turn negative.
        const bool beyond = json.is_number_unsigned() && json.get<std::uint64_t>() > std::uint64_t{INT64_MAX};
        if (parameter.type == ParameterType::real || beyond) return json.get<double>();
        return json.get<std::int64_t>();
    }
    if (json.is_number_float()) {
        const double number = json.get<double>();
        const bool exactly_integer = std::trunc(number) == number && std::abs(number) < 0x1p53;
        if (parameter.type == ParameterType::integer && exactly_integer) return static_cast<std::int64_t>(number);
        return number;
    }
    return std::nullopt;
}

ParameterValue read_parameter_value(const Parameter& parameter, const JsonView& view) {
    const std::optional<ParameterValue> value = parameter_value_from_json(parameter, view.json());
    if (!value) view.fail_expected("a boolean, a number or a string");
    const std::string complaint = check_parameter_value(parameter, *value);
    if (!complaint.empty()) view.fail_here(complaint);
    return *value;
}

}  // namespace reliefbench
