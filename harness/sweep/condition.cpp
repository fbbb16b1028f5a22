#include "sweep/condition.hpp"

#include "core/json_lookup.hpp"
#include "core/suggest.hpp"
#include "manifest/parameter_json.hpp"
#include "sweep/configuration_keys.hpp"
#include "sweep/height_map_value.hpp"
#include "sweep/view_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace reliefbench {

namespace {

/// Of a quantity, told in a message.
constexpr std::size_t max_alternatives = 12;

std::vector<std::string> ids(const ManifestIndex& manifests) {
    std::vector<std::string> found;
    for (const auto& [id, manifest] : manifests)
        found.push_back(id);
    return found;
}

Json read_view_value(const JsonView& view, const ViewAxis& axis) {
    if (axis.name == "heightmap") {
        HeightMapSource source = read_height_map_value(view).source;
        return height_map_label(source);
    }
    const ViewSetting setting = axis.read(view);
    ViewKey key;
    setting(key);
    // A size can be asked for only where there is one.
    if (axis.name == "heightmap_size") return to_string(key.height_map.size);
    return axis.value_in_use ? axis.value_in_use(key) : axis.value(key);
}

/// Right for at least one technique that has the parameter.
Json read_parameter_quantity(const JsonView& view, const std::string& name, const ManifestIndex& manifests) {
    std::string complaint;
    for (const auto& [id, manifest] : manifests) {
        const Parameter* parameter = manifest->find_parameter(name);
        if (!parameter) continue;
        const auto value = parameter_value_from_json(*parameter, view.json());
        if (!value) view.fail_expected("a boolean, a number or a string");
        complaint = check_parameter_value(*parameter, *value);
        if (complaint.empty()) return to_json(*value);
    }
    view.fail_here(complaint);
}

}  // namespace

ManifestIndex index_manifests(const std::vector<Manifest>& manifests) {
    ManifestIndex index;
    for (const Manifest& manifest : manifests)
        index.emplace(manifest.id, &manifest);
    return index;
}

std::vector<std::string> preset_names(const ManifestIndex& manifests) {
    std::vector<std::string> names;
    for (const auto& [id, manifest] : manifests) {
        for (const Preset& preset : manifest->presets)
            names.push_back(preset.name);
    }
    return names;
}

std::vector<std::string> quantity_names(const ManifestIndex& manifests) {
    std::vector<std::string> names{"technique", "preset"};
    for (const ViewAxis& axis : view_axes())
        names.push_back(axis.name);
    names.push_back("sample_count");
    std::set<std::string> parameters;
    for (const auto& [id, manifest] : manifests) {
        for (const Parameter& parameter : manifest->parameters)
            parameters.insert(parameter.name);
    }
    names.insert(names.end(), parameters.begin(), parameters.end());
    return names;
}

void check_quantity_name(const JsonView& where, const std::string& name, const ManifestIndex& manifests) {
    const std::vector<std::string> known = quantity_names(manifests);
    if (std::ranges::find(known, name) != known.end()) return;
    where.fail_here(
        fmt::format("'{}' is neither \"technique\" or \"preset\", nor an axis, nor a parameter of any technique{}",
                    name, suggest_quantity(name, known)));
}

std::string suggest_quantity(const std::string& name, const std::vector<std::string>& known) {
    // First: "step" is nearer to some parameter's name than to what is meant.
    std::vector<std::string> called = axes_also_called(name);
    std::erase_if(called, [&](const std::string& axis) { return std::ranges::find(known, axis) == known.end(); });
    if (!called.empty())
        return fmt::format("; here it is called {}; see `reliefbench list axes`", join(called, " or "));
    const std::vector<std::string>& sampling = configuration_keys::sampling();
    if (std::ranges::find(sampling, name) != sampling.end()) {
        return fmt::format("; it is a setting of \"sampling\": --sampling {}=...", name);
    }
    const std::vector<std::string>& others = configuration_keys::top();
    if (std::ranges::find(others, name) != others.end()) {
        return fmt::format("; \"{}\" stands in a configuration beside its axes", name);
    }
    const std::string suggestion = did_you_mean(name, known);
    return suggestion.empty() ? "; see `reliefbench list axes` and `reliefbench list techniques`" : suggestion;
}

Json cell_quantity(const Cell& cell, const std::string& name, const ManifestIndex& manifests) {
    if (name == "technique") return cell.technique;
    if (name == "preset") return cell.preset.empty() ? Json() : Json(cell.preset);
    if (const ViewAxis* axis = find_view_axis(name)) return axis->value(cell.view);
    std::string parameter = name;
    if (name == "sample_count") {
        const auto manifest = manifests.find(cell.technique);
        if (manifest == manifests.end() || !manifest->second->sample_count) return {};
        parameter = *manifest->second->sample_count;
    }
    const auto value = cell.parameters.find(parameter);
    return value == cell.parameters.end() ? Json() : to_json(value->second);
}

std::vector<Json> distinct_quantities(const std::vector<Cell>& cells, const std::string& name,
                                      const ManifestIndex& manifests) {
    std::vector<Json> values;
    std::set<Json> seen;
    for (const Cell& cell : cells) {
        Json value = cell_quantity(cell, name, manifests);
        if (!value.is_null() && seen.insert(value).second) values.push_back(std::move(value));
    }
    if (std::ranges::all_of(values, [](const Json& value) { return value.is_number(); })) std::ranges::sort(values);
    return values;
}

std::string alternatives(const std::vector<Json>& values) {
    std::vector<std::string> words;
    for (std::size_t index = 0; index < std::min(values.size(), max_alternatives); ++index)
        words.push_back(scalar_text(values[index]));
    if (words.size() < values.size()) return join(words) + ", ...";
    if (words.size() < 2) return join(words);
    const std::string last = words.back();
    words.pop_back();
    return join(words) + " or " + last;
}

std::string value_as_argument(const Json& value) {
    const std::string text = scalar_text(value);
    return value.is_string() && text.find_first_of(",[]{}\"") != std::string::npos ? value.dump() : text;
}

Json read_quantity_value(const JsonView& view, const std::string& name, const ManifestIndex& manifests) {
    if (name == "technique") {
        const std::string id = view.string();
        if (manifests.contains(id)) return id;
        view.fail_here(fmt::format("unknown technique '{}'{}; known are {}", id, did_you_mean(id, ids(manifests)),
                                   join(ids(manifests))));
    }
    if (name == "preset") {
        const std::string preset = view.string();
        const std::vector<std::string> known = preset_names(manifests);
        if (std::ranges::find(known, preset) != known.end()) return preset;
        view.fail_here(
            fmt::format("unknown preset '{}'{}; see `reliefbench list presets`", preset, did_you_mean(preset, known)));
    }
    if (name == "sample_count") return view.integer(1, std::numeric_limits<std::int32_t>::max());
    if (const ViewAxis* axis = find_view_axis(name)) return read_view_value(view, *axis);
    return read_parameter_quantity(view, name, manifests);
}

bool quantity_equals(const std::string& name, const Json& quantity, const Json& value) {
    if (quantity.is_null()) return false;
    if (quantity == value) return true;
    if (name != "heightmap") return false;
    // A file's label is its base name and then, behind plus signs, how it is read.
    const auto& label = quantity.get_ref<const std::string&>();
    const auto& asked = value.get_ref<const std::string&>();
    return label.size() > asked.size() && label.starts_with(asked) && label[asked.size()] == '+';
}

}  // namespace reliefbench
