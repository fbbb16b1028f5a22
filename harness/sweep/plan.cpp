#include "sweep/plan.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "manifest/parameter_json.hpp"
#include "scene/surface/generated_base.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace reliefbench {

namespace {

/// Complaints about an axis as a whole.
[[noreturn]] void fail_axis(const Axis& axis, std::string_view message) {
    fail("{}: {}: {}", axis.origin.file, axis.origin.path, message);
}

JsonView value_view(const Axis& axis, std::size_t index) {
    const std::string path =
        axis.values.size() == 1 ? axis.origin.path : fmt::format("{}[{}]", axis.origin.path, index);
    return {axis.values[index], axis.origin.file, path};
}

/// Which parameter of the technique the axis sets, or null.
const Parameter* parameter_of(const Manifest& manifest, const std::string& axis) {
    if (axis != "sample_count") return manifest.find_parameter(axis);
    return manifest.sample_count ? manifest.find_parameter(*manifest.sample_count) : nullptr;
}

[[noreturn]] void fail_untaken_axis(const Axis& axis, const Plan& plan) {
    if (axis.name == "sample_count") fail_axis(axis, "none of the techniques selected has a sample count");
    if (axis.name == "preset")
        fail_axis(axis, R"(presets are named beside their technique: {"technique": ..., "preset": ...})");
    std::vector<std::string> known;
    for (const ViewAxis& view_axis : view_axes())
        known.push_back(view_axis.name);
    known.push_back("sample_count");
    for (const PlannedTechnique& technique : plan.techniques) {
        for (const Parameter& parameter : technique.manifest->parameters)
            known.push_back(parameter.name);
    }
    std::vector<std::string> owners;
    for (const auto& [id, manifest] : plan.manifests) {
        if (manifest->find_parameter(axis.name)) owners.push_back(id);
    }
    if (!owners.empty()) {
        fail_axis(axis, fmt::format("none of the techniques selected has a parameter '{}', but {} has; select it",
                                    axis.name, join(owners, ", ")));
    }
    fail_axis(axis, fmt::format("unknown axis '{}': neither of the view nor a parameter of a technique selected{}",
                                axis.name, suggest_quantity(axis.name, known)));
}

/// A technique of an earlier contract may have called a parameter what is an axis since.
void refuse_ambiguous(const Axis& axis, const Plan& plan) {
    for (const PlannedTechnique& technique : plan.techniques) {
        const std::string& id = technique.manifest->id;
        if (!technique.manifest->find_parameter(axis.name)) continue;
        fail_axis(axis,
                  fmt::format("'{}' is an axis of the view, and the technique {} has a parameter of that name, "
                              "too: set the parameter by {{\"technique\": \"{}\", \"parameters\": {{\"{}\": ...}}}}, "
                              "or rename it and give the axis",
                              axis.name, id, id, axis.name));
    }
}

/// At least one technique must take each value.
void check_parameter_values(const Axis& axis, const Plan& plan) {
    std::vector<const Parameter*> parameters;
    for (const PlannedTechnique& technique : plan.techniques) {
        if (const Parameter* parameter = parameter_of(*technique.manifest, axis.name)) parameters.push_back(parameter);
    }
    if (parameters.empty()) fail_untaken_axis(axis, plan);
    for (std::size_t index = 0; index < axis.values.size(); ++index) {
        const JsonView view = value_view(axis, index);
        if (axis.name == "sample_count") view.integer(1, std::numeric_limits<std::int32_t>::max());
        if (view.json().is_structured() || view.json().is_null()) view.fail_expected("a boolean, a number or a string");
        std::vector<std::string> complaints;
        const bool taken = std::ranges::any_of(parameters, [&](const Parameter* parameter) {
            complaints.push_back(check_parameter_value(*parameter, axis_parameter_value(*parameter, view.json())));
            return complaints.back().empty();
        });
        if (!taken) view.fail_here(fmt::format("no technique selected takes this value: {}", complaints.front()));
    }
}

PlannedAxis plan_axis(const Axis& axis, const Plan& plan) {
    PlannedAxis planned;
    planned.name = axis.name;
    planned.view = find_view_axis(axis.name);
    if (axis.values.empty()) fail_axis(axis, "an axis needs at least one value");
    if (planned.view) {
        refuse_ambiguous(axis, plan);
        for (std::size_t index = 0; index < axis.values.size(); ++index) {
            planned.settings.push_back(planned.view->read(value_view(axis, index)));
        }
    } else {
        check_parameter_values(axis, plan);
        planned.values = axis.values;
    }
    return planned;
}

/// A curvature that no base of the configuration can have is a mistake; one that some cannot have ends their cells.
void check_curvatures(const Plan& plan, const Configuration& configuration) {
    const auto axis_called = [&](const char* name) { return std::ranges::find(plan.axes, name, &PlannedAxis::name); };
    const auto curved = axis_called("curvature");
    const auto bases = axis_called("base");
    if (curved == plan.axes.end() || bases == plan.axes.end()) return;
    const Axis& axis = configuration.axes[static_cast<std::size_t>(curved - plan.axes.begin())];
    for (std::size_t index = 0; index < curved->settings.size(); ++index) {
        std::string problem;
        bool is_possible = false;
        for (const ViewSetting& set_base : bases->settings) {
            ViewKey view;
            set_base(view);
            curved->settings[index](view);
            if (!view.base.is_generated()) continue;
            problem = curvature_problem(view.base);
            is_possible = is_possible || problem.empty();
        }
        if (!is_possible && !problem.empty()) value_view(axis, index).fail_here(problem);
    }
}

void plan_axes(const Configuration& configuration, Plan& plan) {
    std::set<std::string> names;
    for (const Axis& axis : configuration.axes) {
        if (!names.insert(axis.name).second) fail_axis(axis, fmt::format("the axis '{}' is given twice", axis.name));
        plan.axes.push_back(plan_axis(axis, plan));
    }
    check_curvatures(plan, configuration);
    if (!names.contains("heightmap")) {
        fail("{}: {}.axes: the axis \"heightmap\" is missing; give it one value or more", configuration.origin.file,
             configuration.origin.path);
    }
}

void add_to_group(AxisGroup& group, std::size_t index, const PlannedAxis& axis) {
    group.axes.push_back(index);
    group.length = axis.view ? axis.settings.size() : axis.values.size();
    (axis.view ? group.sets_view : group.sets_parameters) = true;
}

/// For each axis the number of its zip, or -1.
std::vector<int> read_zips(const Configuration& configuration, const Plan& plan) {
    std::vector<int> zip_of(plan.axes.size(), -1);
    std::vector<std::string> known;
    for (const PlannedAxis& axis : plan.axes)
        known.push_back(axis.name);
    for (std::size_t zip = 0; zip < configuration.zip.size(); ++zip) {
        const std::vector<std::string>& names = configuration.zip[zip];
        const auto fail_zip = [&](std::string_view message) {
            fail("{}: {}.zip[{}]: {}", configuration.origin.file, configuration.origin.path, zip, message);
        };
        if (names.size() < 2) fail_zip("a zip ties at least two axes");
        std::vector<std::string> lengths;
        std::set<std::size_t> distinct;
        for (const std::string& name : names) {
            const auto found = std::ranges::find(known, name);
            if (found == known.end()) {
                fail_zip(fmt::format("'{}' is no axis of this configuration{}", name, did_you_mean(name, known)));
            }
            const auto index = static_cast<std::size_t>(found - known.begin());
            if (zip_of[index] >= 0) fail_zip(fmt::format("the axis '{}' is tied twice", name));
            zip_of[index] = static_cast<int>(zip);
            const std::size_t length = configuration.axes[index].values.size();
            lengths.push_back(fmt::format("{} has {}", name, length));
            distinct.insert(length);
        }
        if (distinct.size() > 1) fail_zip("axes tied together need equally many values: " + join(lengths));
    }
    return zip_of;
}

void plan_groups(const Configuration& configuration, Plan& plan) {
    const std::vector<int> zip_of = read_zips(configuration, plan);
    std::vector<std::size_t> group_of_zip(configuration.zip.size(), plan.axes.size());
    for (std::size_t index = 0; index < plan.axes.size(); ++index) {
        std::size_t group = plan.groups.size();
        if (zip_of[index] >= 0) {
            std::size_t& known = group_of_zip[static_cast<std::size_t>(zip_of[index])];
            if (known == plan.axes.size()) known = group;
            group = known;
        }
        if (group == plan.groups.size()) plan.groups.emplace_back();
        add_to_group(plan.groups[group], index, plan.axes[index]);
    }
}

void plan_exclusions(const Configuration& configuration, Plan& plan) {
    for (std::size_t index = 0; index < configuration.exclude.size(); ++index) {
        const std::string path = fmt::format("{}.exclude[{}]", configuration.origin.path, index);
        Exclusion exclusion;
        for (const auto& [name, values] : configuration.exclude[index]) {
            const std::string condition_path = path + "." + name;
            const Json nothing;
            check_quantity_name(JsonView(nothing, configuration.origin.file, condition_path), name, plan.manifests);
            std::vector<Json> read;
            for (const Json& value : values) {
                const JsonView view(value, configuration.origin.file, condition_path);
                read.push_back(read_quantity_value(view, name, plan.manifests));
            }
            exclusion.emplace_back(name, std::move(read));
        }
        plan.exclusions.push_back(std::move(exclusion));
    }
}

}  // namespace

const Manifest& require_technique(const ManifestIndex& manifests, const std::string& id, const JsonView& where) {
    const auto found = manifests.find(id);
    if (found != manifests.end()) return *found->second;
    std::vector<std::string> known;
    for (const auto& [name, manifest] : manifests)
        known.push_back(name);
    where.fail_here(fmt::format("unknown technique '{}'{}; known are {}", id, did_you_mean(id, known), join(known)));
}

const Parameter& require_parameter(const Manifest& manifest, const std::string& name, const JsonView& where) {
    if (const Parameter* parameter = manifest.find_parameter(name)) return *parameter;
    std::vector<std::string> known;
    for (const Parameter& parameter : manifest.parameters)
        known.push_back(parameter.name);
    where.fail_here(fmt::format("the technique {} has no parameter '{}'{}; it has {}", manifest.id, name,
                                did_you_mean(name, known), known.empty() ? "none" : join(known)));
}

const Preset& require_preset(const Manifest& manifest, const std::string& name, const ManifestIndex& manifests,
                             const JsonView& where) {
    if (const Preset* preset = find_preset(manifest, name)) return *preset;
    for (const auto& [id, other] : manifests) {
        if (find_preset(*other, name) == nullptr) continue;
        where.fail_here(fmt::format("'{}' is a preset of the technique {}, not of {}; select it with that one", name,
                                    id, manifest.id));
    }
    const std::vector<std::string> known = preset_names(manifests);
    where.fail_here(
        fmt::format("unknown preset '{}'{}; see `reliefbench list presets`", name, did_you_mean(name, known)));
}

ParameterValue axis_parameter_value(const Parameter& parameter, const Json& value) {
    return parameter_value_from_json(parameter, value).value_or(std::string());
}

Plan plan_sweep(const Configuration& configuration, const std::vector<Manifest>& techniques) {
    Plan plan;
    plan.manifests = index_manifests(techniques);
    if (configuration.techniques.empty()) {
        fail("{}: {}.techniques: select at least one technique", configuration.origin.file, configuration.origin.path);
    }
    for (const TechniqueSelection& selection : configuration.techniques) {
        const Json nothing;
        const JsonView where(nothing, selection.origin.file, selection.origin.path);
        const Manifest& manifest = require_technique(plan.manifests, selection.technique, where);
        for (const auto& [name, values] : selection.parameters) {
            const Parameter& parameter = require_parameter(manifest, name, where);
            for (const ParameterValue& value : values) {
                const std::string complaint = check_parameter_value(parameter, value);
                if (!complaint.empty()) where.fail_here(complaint);
            }
        }
        if (selection.presets.empty()) plan.techniques.push_back({&manifest, &selection, nullptr});
        for (const std::string& preset : selection.presets)
            plan.techniques.push_back(
                {&manifest, &selection, &require_preset(manifest, preset, plan.manifests, where)});
    }
    plan_axes(configuration, plan);
    plan_groups(configuration, plan);
    plan_exclusions(configuration, plan);
    return plan;
}

}  // namespace reliefbench
