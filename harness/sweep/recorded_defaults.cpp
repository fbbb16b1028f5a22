#include "sweep/recorded_defaults.hpp"

#include "core/json_lookup.hpp"
#include "manifest/parameter_json.hpp"
#include "sweep/view_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace reliefbench {

namespace {

/// Whether the axes or the selection of the technique say what the parameter is.
bool is_set(const Manifest& manifest, const std::string& parameter, const Json& selection, const Json& axes) {
    const bool counted = manifest.sample_count == parameter || manifest.sample_count_minimum == parameter;
    return value_at(selection, {"parameters", parameter.c_str()}) != nullptr || axes.contains(parameter) ||
           (counted && axes.contains("sample_count"));
}

void set_parameters(Json& selection, const Json& axes, const Json& recorded, const Manifest& manifest,
                    std::vector<std::string>& changes) {
    for (const Parameter& parameter : manifest.parameters) {
        const Json then = value_at(recorded, {parameter.name.c_str()});
        const Json now = to_json(parameter.default_value);
        if (then.is_null() || then == now || is_set(manifest, parameter.name, selection, axes)) continue;
        selection["parameters"][parameter.name] = then;
        changes.push_back(fmt::format("{}: {}={}, which is {} by default now", manifest.id, parameter.name,
                                      scalar_text(then), scalar_text(now)));
    }
}

void set_axes(Json& axes, const Json& recorded, std::vector<std::string>& changes) {
    for (const ViewAxis& axis : view_axes()) {
        const Json then = value_at(recorded, {axis.name.c_str()});
        if (then.is_null() || then == axis.default_value || axes.contains(axis.name)) continue;
        axes[axis.name] = then;
        changes.push_back(fmt::format("{}={}, which is {} by default now", axis.name, scalar_text(then),
                                      scalar_text(axis.default_value)));
    }
}

}  // namespace

RepeatedConfiguration with_recorded_defaults(Json configuration, const Json& defaults,
                                             const std::vector<Manifest>& manifests) {
    RepeatedConfiguration repeated{std::move(configuration), {}};
    if (!repeated.configuration.is_object()) return repeated;
    const auto axes = repeated.configuration.find("axes");
    const auto techniques = repeated.configuration.find("techniques");
    // What is not as it is written is complained of by who reads it.
    if (axes == repeated.configuration.end() || !axes->is_object() || techniques == repeated.configuration.end() ||
        !techniques->is_array()) {
        return repeated;
    }
    for (Json& selection : *techniques) {
        const auto id = value_at(selection, {"technique"});
        const auto manifest = std::ranges::find_if(manifests, [&](const Manifest& each) { return id == each.id; });
        if (manifest == manifests.end()) continue;
        set_parameters(selection, *axes, value_at(defaults, {"parameters", manifest->id.c_str()}), *manifest,
                       repeated.changes);
    }
    set_axes(*axes, value_at(defaults, {"axes"}), repeated.changes);
    return repeated;
}

}  // namespace reliefbench
