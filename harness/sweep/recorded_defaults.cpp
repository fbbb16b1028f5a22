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

void set_parameters(Json& selection, const SetNames& set, const Json& recorded, const Manifest& manifest,
                    std::vector<ChangedDefault>& changes) {
    for (const Parameter& parameter : manifest.parameters) {
        const Json then = value_at(recorded, {parameter.name.c_str()});
        const Json now = to_json(parameter.default_value);
        if (then.is_null() || then == now || set.has_parameter(manifest, parameter.name, selection)) continue;
        selection["parameters"][parameter.name] = then;
        changes.push_back({manifest.id, fmt::format("{}: {}={}, which is {} by default now", manifest.id,
                                                    parameter.name, scalar_text(then), scalar_text(now))});
    }
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
    for (Json& selection : *techniques) {
        const Json id = value_at(selection, {"technique"});
        const auto manifest = std::ranges::find_if(manifests, [&](const Manifest& each) { return id == each.id; });
        if (manifest == manifests.end()) continue;
        const Json recorded = value_at(defaults, {"parameters", manifest->id.c_str()});
        if (recorded.is_null() && !manifest->parameters.empty()) repeated.unknown.push_back(manifest->id);
        set_parameters(selection, set, recorded, *manifest, repeated.changes);
    }
    set_axes(*axes, set, value_at(defaults, {"axes"}), repeated.changes);
    return repeated;
}

}  // namespace reliefbench
