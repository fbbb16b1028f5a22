#include "sweep/recorded_defaults.hpp"

#include "core/json_lookup.hpp"
#include "manifest/parameter_json.hpp"
#include "sweep/view_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace reliefbench {

namespace {

/// What of a configuration says what a parameter or an axis is.
class SetNames {
public:
    SetNames(const Json& axes, const std::vector<std::string>& overridden)
        : names_(overridden.begin(), overridden.end()) {
        for (const auto& [name, values] : axes.items())
            names_.insert(name);
    }

    bool has_axis(const std::string& name) const { return names_.contains(name); }
    bool has_parameter(const Manifest& manifest, const std::string& name, const Json& selection) const {
        const bool is_counted = manifest.sample_count == name || manifest.sample_count_minimum == name;
        return value_at(selection, {"parameters", name.c_str()}) != nullptr || has_axis(name) ||
               (is_counted && has_axis("sample_count"));
    }

private:
    std::set<std::string> names_;
};

/// Without a preset where `preset` is null; `recorded` is of the technique's defaults.
void set_parameters(Json& selection, const SetNames& set, const Json& recorded, const Json& recorded_preset,
                    const Manifest& manifest, const Preset* preset, std::vector<ChangedDefault>& changes) {
    const ParameterValues values = values_of_preset(manifest, preset);
    for (const Parameter& parameter : manifest.parameters) {
        const Json of_preset = value_at(recorded_preset, {parameter.name.c_str()});
        const Json then = of_preset.is_null() ? value_at(recorded, {parameter.name.c_str()}) : of_preset;
        const Json now = to_json(values.at(parameter.name));
        if (then.is_null() || then == now || set.has_parameter(manifest, parameter.name, selection)) continue;
        selection["parameters"][parameter.name] = then;
        const std::string whose = preset == nullptr ? "by default" : fmt::format("in the preset {}", preset->name);
        changes.push_back({manifest.id, fmt::format("{}: {}={}, which is {} {} now", manifest.id, parameter.name,
                                                    scalar_text(then), scalar_text(now), whose)});
    }
}

/// Of an entry of "techniques"; each of several presets gets one of its own where one has changed.
std::vector<Json> with_parameters(const Json& selection, const SetNames& set, const Json& defaults,
                                  const Manifest& manifest, std::vector<ChangedDefault>& changes) {
    const Json recorded = value_at(defaults, {"parameters", manifest.id.c_str()});
    const std::size_t changes_before = changes.size();
    std::vector<Json> selections;
    Json names = value_at(selection, {"preset"});
    if (!names.is_array()) names = Json::array({names});
    for (const Json& name : names) {
        selections.push_back(selection);
        const Preset* const preset = name.is_string() ? find_preset(manifest, name.get<std::string>()) : nullptr;
        // One that there is no more is complained of by who reads it.
        if (preset == nullptr && !name.is_null()) continue;
        if (preset != nullptr) selections.back()["preset"] = preset->name;
        const Json of_preset =
            preset == nullptr
                ? Json()
                : value_at(defaults, {"presets", manifest.id.c_str(), preset->name.c_str(), "parameters"});
        set_parameters(selections.back(), set, recorded, of_preset, manifest, preset, changes);
    }
    if (changes.size() == changes_before) return {selection};
    return selections;
}

void set_axes(Json& axes, const SetNames& set, const Json& recorded, std::vector<ChangedDefault>& changes) {
    for (const ViewAxis& axis : view_axes()) {
        const Json then = value_at(recorded, {axis.name.c_str()});
        if (then.is_null() || then == axis.default_value || set.has_axis(axis.name)) continue;
        axes[axis.name] = then;
        changes.push_back({"", fmt::format("{}={}, which is {} by default now", axis.name, scalar_text(then),
                                           scalar_text(axis.default_value))});
    }
}

}  // namespace

RepeatedConfiguration with_recorded_defaults(Json configuration, const Json& defaults,
                                             const std::vector<Manifest>& manifests,
                                             const std::vector<std::string>& overridden) {
    RepeatedConfiguration repeated{.configuration = std::move(configuration), .changes = {}, .unknown = {}};
    if (!repeated.configuration.is_object()) return repeated;
    const auto axes = repeated.configuration.find("axes");
    const auto techniques = repeated.configuration.find("techniques");
    // What is not as it is written is complained of by who reads it.
    if (axes == repeated.configuration.end() || !axes->is_object() || techniques == repeated.configuration.end() ||
        !techniques->is_array()) {
        return repeated;
    }
    const SetNames set(*axes, overridden);
    std::vector<Json> selections;
    for (const Json& selection : *techniques) {
        const Json id = value_at(selection, {"technique"});
        const auto manifest = std::ranges::find_if(manifests, [&](const Manifest& each) { return id == each.id; });
        if (manifest == manifests.end()) {
            selections.push_back(selection);
            continue;
        }
        const Json recorded = value_at(defaults, {"parameters", manifest->id.c_str()});
        if (recorded.is_null() && !manifest->parameters.empty()) repeated.unknown.push_back(manifest->id);
        std::ranges::move(with_parameters(selection, set, defaults, *manifest, repeated.changes),
                          std::back_inserter(selections));
    }
    *techniques = std::move(selections);
    set_axes(*axes, set, value_at(defaults, {"axes"}), repeated.changes);
    return repeated;
}

}  // namespace reliefbench
