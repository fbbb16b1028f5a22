#include "manifest/preset.hpp"

#include "manifest/manifest.hpp"
#include "manifest/parameter_json.hpp"
#include "manifest/parse_names.hpp"
#include "manifest/parse_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reliefbench {

namespace {

std::string parse_preset_name(const JsonView& view) {
    const std::string name = view.string();
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    if (name.empty() || name.front() < 'a' || name.front() > 'z' || !std::ranges::all_of(name, fits))
        view.fail_expected("a name of lower case letters, digits and '_', a letter first");
    return name;
}

Preset parse_preset(const JsonView& view, const Manifest& manifest) {
    view.require_only({"name", "title", "source", "parameters", "not_expressed"});
    Preset preset;
    preset.name = parse_preset_name(view.at("name"));
    preset.title = parse_line(view.at("title"));
    preset.source = parse_line(view.at("source"));
    const JsonView parameters = view.at("parameters");
    preset.parameters = parse_values(parameters, manifest);
    if (view.has("not_expressed")) preset.not_expressed = parse_line(view.at("not_expressed"));
    const ParameterValues values = values_of_preset(manifest, &preset);
    for (const auto& [name, value] : preset.parameters) {
        const Parameter& parameter = *manifest.find_parameter(name);
        if (has_effect(parameter, values, true)) continue;
        parameters.at(name).fail_here(
            fmt::format("'{}' has no effect in this preset: it needs {}", name, describe_needs(parameter)));
    }
    return preset;
}

}  // namespace

std::vector<Preset> parse_presets(const JsonView& view, const Manifest& manifest) {
    std::vector<Preset> presets;
    for (const JsonView& item : view.items()) {
        Preset preset = parse_preset(item, manifest);
        if (std::ranges::find(presets, preset.name, &Preset::name) != presets.end())
            item.at("name").fail_here(fmt::format("the preset '{}' is given twice", preset.name));
        presets.push_back(std::move(preset));
    }
    return presets;
}

Json to_json(const Preset& preset) {
    Json parameters = Json::object();
    for (const auto& [name, value] : preset.parameters)
        parameters[name] = to_json(value);
    return {{"title", preset.title},
            {"source", preset.source},
            {"parameters", std::move(parameters)},
            {"not_expressed", preset.not_expressed}};
}

const Preset* find_preset(const Manifest& manifest, const std::string& name) {
    const auto found = std::ranges::find(manifest.presets, name, &Preset::name);
    return found == manifest.presets.end() ? nullptr : &*found;
}

ParameterValues values_of_preset(const Manifest& manifest, const Preset* preset) {
    ParameterValues values = manifest.defaults();
    if (preset == nullptr) return values;
    for (const auto& [name, value] : preset->parameters)
        values.at(name) = value;
    return values;
}

}  // namespace reliefbench
