#include "manifest/parse_parameter.hpp"

#include "core/suggest.hpp"
#include "manifest/parameter_json.hpp"
#include "manifest/reserved_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace reliefbench {

namespace {

constexpr std::int64_t int32_minimum = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t int32_maximum = std::numeric_limits<std::int32_t>::max();
constexpr double float_maximum = std::numeric_limits<float>::max();

/// In the order of the enumeration.
const std::vector<std::string> parameter_types{"integer", "real", "boolean", "choice"};

std::vector<std::string> parse_choices(const JsonView& view, const std::string& parameter, GlslNames& names) {
    std::vector<std::string> choices;
    for (const JsonView& item : view.items()) {
        const std::string word = item.string();
        const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
        const auto fits = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
        if (word.empty() || !letter(word.front()) || word.back() == '_' || !std::ranges::all_of(word, fits) ||
            word.find("__") != std::string::npos) {
            item.fail_expected("a word of letters, digits and single underscores, a letter first");
        }
        names.add(item, parameter + "_" + word);
        choices.push_back(word);
    }
    if (choices.empty()) view.fail_expected("at least one choice");
    return choices;
}

void add_macros(const JsonView& view, const Parameter& parameter, GlslNames& names) {
    if (parameter.type == ParameterType::boolean) names.add(view.at("name"), compile_time_macro(parameter));
    for (std::size_t i = 0; i < parameter.choices.size(); ++i)
        names.add(view.at("choices").items()[i], compile_time_macro(parameter, parameter.choices[i]));
}

void parse_range(const JsonView& view, Parameter& parameter) {
    const std::vector<JsonView> ends = view.items();
    if (ends.size() != 2) view.fail_expected("[minimum, maximum]");
    const auto read = [&](const JsonView& end) {
        if (parameter.type == ParameterType::real) return end.number(-float_maximum, float_maximum);
        return static_cast<double>(end.integer(int32_minimum, int32_maximum));
    };
    parameter.minimum = read(ends[0]);
    parameter.maximum = read(ends[1]);
    if (parameter.minimum > parameter.maximum) view.fail_expected("a minimum that is not above the maximum");
}

}  // namespace

void GlslNames::add_checked(const JsonView& view) {
    const std::string complaint = check_glsl_name(view.string(), contract_);
    if (!complaint.empty()) view.fail_here(complaint);
    add(view, view.string());
}

void GlslNames::add(const JsonView& view, const std::string& name) {
    if (!names_.insert(name).second) view.fail_here(fmt::format("the name '{}' is given twice", name));
    places_.emplace_back(name, view);
}

void GlslNames::require_none_of(const std::set<std::string>& names_of_shaders) const {
    for (const auto& [name, view] : places_) {
        if (names_of_shaders.contains(name))
            view.fail_here(fmt::format("'{}' is a name that the harness's shaders use; choose another", name));
    }
}

std::string parse_line(const JsonView& view) {
    const std::string text = view.string();
    if (text.empty() || text.find('\n') != std::string::npos) view.fail_expected("one line of text");
    return text;
}

Parameter parse_parameter(const JsonView& view, GlslNames& names) {
    Parameter parameter;
    names.add_checked(view.at("name"));
    parameter.name = view.at("name").string();
    parameter.type = static_cast<ParameterType>(view.at("type").choice(parameter_types));

    std::vector<std::string> keys{"name", "type", "default", "help", "published", "only_with", "only_on"};
    switch (parameter.type) {
        case ParameterType::integer:
        case ParameterType::real:
            keys.push_back("range");
            view.require_only(keys);
            parse_range(view.at("range"), parameter);
            break;
        case ParameterType::choice:
            keys.insert(keys.end(), {"choices", "compile_time"});
            view.require_only(keys);
            parameter.choices = parse_choices(view.at("choices"), parameter.name, names);
            break;
        case ParameterType::boolean:
            keys.push_back("compile_time");
            view.require_only(keys);
            break;
    }
    parameter.default_value = read_parameter_value(parameter, view.at("default"));
    if (view.has("compile_time")) parameter.compile_time = view.at("compile_time").boolean();
    if (parameter.compile_time) add_macros(view, parameter, names);
    if (view.has("published")) parameter.published = read_parameter_value(parameter, view.at("published"));
    if (view.has("only_on"))
        parameter.only_on =
            view.at("only_on").choice({"plane", "curved_base"}) == 0 ? BaseKinds::plane : BaseKinds::curved;
    parameter.help = parse_line(view.at("help"));
    return parameter;
}

Parameter parse_override(const JsonView& view, Parameter parameter, const std::string& set) {
    if (view.has("type")) {
        view.fail_here(fmt::format(
            "'{}' is a parameter of {}, which may be given another default, range, published value or help here; a "
            "parameter of this technique's own needs another name",
            parameter.name, set));
    }
    std::vector<std::string> keys{"name", "default", "published", "help"};
    if (parameter.type == ParameterType::integer || parameter.type == ParameterType::real) keys.push_back("range");
    view.require_only(keys);
    if (view.has("range")) {
        const Parameter whole = parameter;
        parse_range(view.at("range"), parameter);
        if (parameter.minimum < whole.minimum || parameter.maximum > whole.maximum) {
            view.at("range").fail_expected(
                fmt::format("a range within that of {}, {} to {}", set, whole.minimum, whole.maximum));
        }
    }
    if (view.has("default")) parameter.default_value = read_parameter_value(parameter, view.at("default"));
    const std::string complaint = check_parameter_value(parameter, parameter.default_value);
    if (!complaint.empty()) view.fail_here(complaint);
    if (view.has("published")) parameter.published = read_parameter_value(parameter, view.at("published"));
    if (view.has("help")) parameter.help = parse_line(view.at("help"));
    return parameter;
}

std::vector<ParameterCondition> parse_conditions(const JsonView& view, const std::vector<Parameter>& parameters) {
    std::vector<ParameterCondition> conditions;
    for (const auto& [name, value] : view.members()) {
        const auto found = std::ranges::find(parameters, name, &Parameter::name);
        if (found == parameters.end()) {
            std::vector<std::string> names;
            for (const Parameter& parameter : parameters)
                names.push_back(parameter.name);
            value.fail_here(fmt::format("no parameter '{}' is declared before{}", name, did_you_mean(name, names)));
        }
        ParameterCondition condition{name, {}};
        const std::vector<JsonView> values = value.json().is_array() ? value.items() : std::vector<JsonView>{value};
        for (const JsonView& item : values)
            condition.values.push_back(read_parameter_value(*found, item));
        if (condition.values.empty()) value.fail_expected("at least one value");
        conditions.push_back(std::move(condition));
    }
    if (conditions.empty()) view.fail_expected("at least one parameter");
    return conditions;
}

}  // namespace reliefbench
