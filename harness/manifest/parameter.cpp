#include "manifest/parameter.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace reliefbench {

namespace {

std::string expected(const Parameter& parameter) {
    switch (parameter.type) {
        case ParameterType::integer:
            return fmt::format("an integer from {} to {}", parameter.minimum, parameter.maximum);
        case ParameterType::real:
            return fmt::format("a number from {} to {}", parameter.minimum, parameter.maximum);
        case ParameterType::boolean:
            return "true or false";
        case ParameterType::choice:
            return "one of " + join(parameter.choices);
    }
    return {};
}

std::string complain(const Parameter& parameter, const ParameterValue& value) {
    return fmt::format("{} cannot be {}: it is {}", parameter.name, to_string(value), expected(parameter));
}

bool in_range(const Parameter& parameter, double number) {
    return std::isfinite(number) && number >= parameter.minimum && number <= parameter.maximum;
}

}  // namespace

std::string compile_time_macro(const Parameter& parameter, const std::string& choice) {
    std::string macro = choice.empty() ? parameter.name : parameter.name + "_" + choice;
    std::ranges::transform(macro, macro.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return macro;
}

bool all_hold(const std::vector<ParameterCondition>& conditions, const ParameterValues& values) {
    return std::ranges::all_of(conditions, [&](const ParameterCondition& condition) {
        return std::ranges::find(condition.values, values.at(condition.parameter)) != condition.values.end();
    });
}

std::string describe(const std::vector<ParameterCondition>& conditions) {
    std::vector<std::string> texts;
    for (const ParameterCondition& condition : conditions) {
        std::vector<std::string> values;
        for (const ParameterValue& value : condition.values)
            values.push_back(to_string(value));
        texts.push_back(condition.parameter + "=" + join(values, " or "));
    }
    return join(texts);
}

bool has_effect(const Parameter& parameter, const ParameterValues& values, bool on_flat_base) {
    const bool is_idle_here = parameter.only_on == (on_flat_base ? BaseKinds::curved : BaseKinds::plane);
    return all_hold(parameter.only_with, values) && !is_idle_here;
}

std::string describe_needs(const Parameter& parameter) {
    std::vector<std::string> needs;
    if (!parameter.only_with.empty()) needs.push_back(describe(parameter.only_with));
    if (parameter.only_on == BaseKinds::curved) needs.emplace_back("a base other than the plane");
    if (parameter.only_on == BaseKinds::plane) needs.emplace_back("the plane as base");
    return join(needs);
}

std::string to_string(const ParameterValue& value) {
    struct Writer {
        std::string operator()(bool held) const { return held ? "true" : "false"; }
        std::string operator()(std::int64_t held) const { return fmt::format("{}", held); }
        std::string operator()(double held) const { return fmt::format("{}", held); }
        std::string operator()(const std::string& held) const { return held; }
    };
    return std::visit(Writer{}, value);
}

ParameterValue parse_parameter_value(const Parameter& parameter, const std::string& text) {
    switch (parameter.type) {
        case ParameterType::integer:
            if (const auto number = whole_text_as<std::int64_t>(text)) return *number;
            break;
        case ParameterType::real:
            if (const auto number = whole_text_as<double>(text); number && std::isfinite(*number)) return *number;
            break;
        case ParameterType::boolean:
            if (text == "true" || text == "false") return text == "true";
            break;
        case ParameterType::choice:
            return text;
    }
    fail("{}", complain(parameter, text));
}

std::string check_parameter_value(const Parameter& parameter, const ParameterValue& value) {
    bool valid = false;
    switch (parameter.type) {
        case ParameterType::integer: {
            const auto* number = std::get_if<std::int64_t>(&value);
            valid = number && in_range(parameter, static_cast<double>(*number));
            break;
        }
        case ParameterType::real: {
            const auto* number = std::get_if<double>(&value);
            valid = number && in_range(parameter, *number);
            break;
        }
        case ParameterType::boolean:
            valid = std::holds_alternative<bool>(value);
            break;
        case ParameterType::choice: {
            const auto* word = std::get_if<std::string>(&value);
            valid = word && std::ranges::find(parameter.choices, *word) != parameter.choices.end();
            if (word && !valid) return complain(parameter, value) + did_you_mean(*word, parameter.choices);
            break;
        }
    }
    return valid ? std::string() : complain(parameter, value);
}

}  // namespace reliefbench
