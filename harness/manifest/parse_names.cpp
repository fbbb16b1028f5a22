#include "manifest/parse_names.hpp"

#include "core/suggest.hpp"
#include "manifest/parameter_json.hpp"

#include <fmt/format.h>

#include <vector>

namespace reliefbench {

namespace {

const Parameter& find_named(const JsonView& view, const Manifest& manifest, const std::string& name) {
    if (const Parameter* parameter = manifest.find_parameter(name)) return *parameter;
    std::vector<std::string> names;
    for (const Parameter& parameter : manifest.parameters)
        names.push_back(parameter.name);
    view.fail_here(fmt::format("no parameter '{}'{}", name, did_you_mean(name, names)));
}

}  // namespace

std::string parse_integer_name(const JsonView& view, const Manifest& manifest) {
    const std::string name = view.string();
    if (find_named(view, manifest, name).type != ParameterType::integer) {
        view.fail_here(fmt::format("the parameter '{}' must be of type integer", name));
    }
    return name;
}

ParameterValues parse_values(const JsonView& view, const Manifest& manifest) {
    ParameterValues values;
    for (const auto& [name, value] : view.members())
        values.emplace(name, read_parameter_value(find_named(value, manifest, name), value));
    return values;
}

}  // namespace reliefbench
