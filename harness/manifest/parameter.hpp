#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace reliefbench {

enum class ParameterType { integer, real, boolean, choice };

/// A choice is held as its word. Booleans come first so that no other type converts into them silently.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

enum class BaseKinds { all, plane, curved };

/// That a parameter has one of these values.
struct ParameterCondition {
    std::string parameter;
    std::vector<ParameterValue> values;
};

/// A technique's parameter, declared once in technique.json; it drives the CLI, the checks, the documents and the
/// specialization constant of the same name.
struct Parameter {
    std::string name;
    ParameterType type = ParameterType::integer;
    ParameterValue default_value;
    /// Integer and real only, both ends included.
    double minimum = 0;
    double maximum = 0;
    /// Choice only. GLSL sees the index, and a constant <name>_<choice> for each.
    std::vector<std::string> choices;
    /// One line.
    std::string help;
    /// The value that the cited paper or sample uses, where it says one.
    std::optional<ParameterValue> published;
    /// Known when GLSL is compiled, which then is done for each value: for what no specialization constant can decide.
    bool compile_time = false;
    /// All must hold, or the parameter has no effect: it is idle and keeps its default. They name parameters before it.
    std::vector<ParameterCondition> only_with = {};
    /// Over which bases it has an effect; it is idle over others.
    BaseKinds only_on = BaseKinds::all;
};

/// Values by name. In a cell always complete: every parameter of the technique has one.
using ParameterValues = std::map<std::string, ParameterValue>;

/// What a parameter of compile time defines for the preprocessor when it has this choice, "LEAF_EXACT", or as a boolean
/// when it is true, "ADAPTIVE".
std::string compile_time_macro(const Parameter& parameter, const std::string& choice = {});

/// Whether all of the conditions hold; the values must be complete.
bool all_hold(const std::vector<ParameterCondition>& conditions, const ParameterValues& values);

/// "refinement=binary, leaf=linear or exact".
std::string describe(const std::vector<ParameterCondition>& conditions);

/// Whether the parameter changes anything beside the others' values; they must be complete.
bool has_effect(const Parameter& parameter, const ParameterValues& values, bool on_flat_base);

/// What it needs for that, "refinement=binary, a base other than the plane"; empty where that is nothing.
std::string describe_needs(const Parameter& parameter);

/// "64", "0.5", "true", "exact": as the CLI and cell ids write it. Reals in the shortest form that reads back equal.
std::string to_string(const ParameterValue& value);

/// Reads `text` as a value of the parameter's type. Throws Error when it is not of that type (says what is expected);
/// does not check the range.
ParameterValue parse_parameter_value(const Parameter& parameter, const std::string& text);

/// Empty when the value is of the right type and in range, else one sentence saying what is wrong and what is allowed.
std::string check_parameter_value(const Parameter& parameter, const ParameterValue& value);

}  // namespace reliefbench
