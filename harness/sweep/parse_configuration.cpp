#include "core/error.hpp"
#include "core/log.hpp"
#include "core/split.hpp"
#include "core/suggest.hpp"
#include "manifest/parameter_json.hpp"
#include "sweep/base_value.hpp"
#include "sweep/configuration.hpp"
#include "sweep/configuration_keys.hpp"
#include "sweep/height_map_value.hpp"
#include "sweep/override.hpp"
#include "sweep/plan.hpp"
#include "sweep/settings.hpp"

#include <algorithm>

namespace reliefbench {

namespace {

using Folders = std::vector<std::filesystem::path>;

/// Of a configuration that neither names itself nor has a file's name.
constexpr std::string_view unnamed = "configuration";

/// Told by the path alone: a pipe that has been read may be gone.
bool has_name_of_its_own(const std::filesystem::path& file) {
    const std::filesystem::path plain = std::filesystem::path(file).lexically_normal();
    const auto below = [&](const char* folder) { return plain.is_absolute() && *std::next(plain.begin()) == folder; };
    return file != standard_input && !below("dev") && !below("proc");
}

/// A list, or one value that stands for a list of itself.
std::vector<JsonView> one_or_more(const JsonView& view) {
    if (!view.json().is_array()) return {view};
    std::vector<JsonView> items = view.items();
    if (items.empty()) view.fail_expected("at least one value");
    return items;
}

TechniqueSelection read_selection(const JsonView& view, const ManifestIndex& manifests) {
    TechniqueSelection selection;
    selection.origin = {view.file(), view.path()};
    if (view.json().is_string()) {
        selection.technique = require_technique(manifests, view.string(), view).id;
        return selection;
    }
    if (!view.json().is_object()) view.fail_expected("a technique's id, or {\"technique\": id, \"parameters\": {...}}");
    view.require_only(configuration_keys::technique());
    const JsonView id = view.at("technique");
    const Manifest& manifest = require_technique(manifests, id.string(), id);
    selection.technique = manifest.id;
    if (view.has("preset")) {
        for (const JsonView& preset : one_or_more(view.at("preset")))
            selection.presets.push_back(require_preset(manifest, preset.string(), manifests, preset).name);
    }
    if (!view.has("parameters")) return selection;
    for (const auto& [name, values] : view.at("parameters").members()) {
        const Parameter& parameter = require_parameter(manifest, name, values);
        std::vector<ParameterValue> read;
        for (const JsonView& value : one_or_more(values))
            read.push_back(read_parameter_value(parameter, value));
        selection.parameters.emplace_back(name, std::move(read));
    }
    return selection;
}

/// With absolute paths of files, where the axis takes some.
Json resolve_axis_value(const std::string& axis, const JsonView& value, const Folders& folders) {
    if (axis == "heightmap") return resolve_height_map_paths(value, folders);
    if (axis == "base") return resolve_base_path(value, folders);
    if (axis == "albedo") return resolve_albedo_path(value, folders);
    return value.json();
}

Axis read_axis(const std::string& name, const JsonView& view, const Folders& folders) {
    Axis axis{name, {}, {view.file(), view.path()}};
    for (const JsonView& value : one_or_more(view))
        axis.values.push_back(resolve_axis_value(name, value, folders));
    return axis;
}

std::vector<std::vector<std::string>> read_zip(const JsonView& view) {
    std::vector<std::vector<std::string>> zip;
    for (const JsonView& group : view.items()) {
        zip.emplace_back();
        for (const JsonView& name : group.items())
            zip.back().push_back(name.string());
    }
    return zip;
}

std::map<std::string, std::vector<Json>> read_exclusion(const JsonView& view) {
    std::map<std::string, std::vector<Json>> conditions;
    for (const auto& [name, values] : view.members()) {
        for (const JsonView& value : one_or_more(values))
            conditions[name].push_back(value.json());
    }
    if (conditions.empty()) view.fail_expected("at least one condition");
    return conditions;
}

Configuration read(const JsonView& view, const ManifestIndex& manifests) {
    view.require_only(configuration_keys::top());
    Configuration configuration;
    configuration.origin = {view.file(), view.path()};
    const std::filesystem::path file = view.file();
    const bool named = has_name_of_its_own(file);
    configuration.name = view.has("name") ? view.at("name").string()
                         : named          ? file.stem().string()
                                          : std::string(unnamed);
    for (const JsonView& item : view.at("techniques").items()) {
        configuration.techniques.push_back(read_selection(item, manifests));
    }
    const Folders folders{!named || file.parent_path().empty() ? "." : file.parent_path(), "."};
    for (const auto& [name, values] : view.at("axes").members()) {
        configuration.axes.push_back(read_axis(name, values, folders));
    }
    if (view.has("zip")) configuration.zip = read_zip(view.at("zip"));
    if (view.has("exclude")) {
        for (const JsonView& item : view.at("exclude").items())
            configuration.exclude.push_back(read_exclusion(item));
    }
    if (view.has("seed")) configuration.seed = static_cast<std::uint64_t>(view.at("seed").integer(0));
    if (view.has("truth")) configuration.truth = read_truth(view.at("truth"));
    if (view.has("sampling")) configuration.sampling = read_sampling(view.at("sampling"));
    if (view.has("preparation")) configuration.preparation = read_preparation(view.at("preparation"));
    if (view.has("lighting")) configuration.lighting = read_lighting(view.at("lighting"));
    if (view.has("object")) configuration.object = read_object(view.at("object"));
    if (view.has("images")) configuration.images = view.at("images").boolean();
    if (view.has("motion")) configuration.motion = read_motion(view.at("motion"));
    return configuration;
}

/// "technique=a,b": those selected before keep the values of their parameters.
void override_techniques(const Override& given, Configuration& configuration, const ManifestIndex& manifests) {
    std::vector<TechniqueSelection> selected;
    for (const Json& value : given.values) {
        const std::string id = require_technique(manifests, JsonView(value, given.argument, given.name).string(),
                                                 JsonView(value, given.argument, given.name))
                                   .id;
        const std::size_t before = selected.size();
        std::ranges::copy_if(configuration.techniques, std::back_inserter(selected),
                             [&](const TechniqueSelection& earlier) { return earlier.technique == id; });
        if (selected.size() == before) selected.push_back({id, {}, {given.argument, given.name}});
    }
    configuration.techniques = std::move(selected);
}

/// "preset=a,b": each for the techniques selected that have it, in place of their presets; the others stay as they are.
void override_presets(const Override& given, Configuration& configuration, const ManifestIndex& manifests) {
    std::map<std::string, std::vector<std::string>> chosen;
    for (const Json& value : given.values) {
        const JsonView view(value, given.argument, given.name);
        const std::string name = view.string();
        bool is_taken = false;
        for (const TechniqueSelection& selection : configuration.techniques) {
            if (find_preset(*manifests.at(selection.technique), name) == nullptr) continue;
            is_taken = true;
            std::vector<std::string>& names = chosen[selection.technique];
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
        }
        // Says what is wrong with it.
        if (!is_taken) require_preset(*manifests.at(configuration.techniques.front().technique), name, manifests, view);
    }
    for (TechniqueSelection& selection : configuration.techniques) {
        const auto presets = chosen.find(selection.technique);
        if (presets != chosen.end()) selection.presets = presets->second;
    }
}

/// The values hold for all that the axes were tied to; a zip of one axis ties nothing.
void untie(const std::vector<Override>& overrides, Configuration& configuration) {
    for (std::vector<std::string>& names : configuration.zip) {
        LoosenedZip loosened;
        for (const Override& given : overrides) {
            if (std::erase(names, given.name) == 0) continue;
            loosened.taken.push_back(given.name);
            loosened.arguments.push_back(given.argument);
        }
        loosened.kept = names;
        if (!loosened.taken.empty()) configuration.loosened_zips.push_back(std::move(loosened));
    }
    std::erase_if(configuration.zip, [](const std::vector<std::string>& names) { return names.size() < 2; });
}

/// Of height maps that are given as objects.
void drop_own_albedos(Configuration& configuration) {
    for (Axis& axis : configuration.axes) {
        if (axis.name != "heightmap") continue;
        for (Json& value : axis.values) {
            if (value.is_object()) value.erase("albedo");
        }
    }
}

/// The axis takes the place of whatever set the same before.
void override_axis(const Override& given, Configuration& configuration, const ManifestIndex& manifests) {
    for (TechniqueSelection& selection : configuration.techniques) {
        const Manifest& manifest = *manifests.at(selection.technique);
        const std::string parameter =
            given.name == "sample_count" ? manifest.sample_count.value_or(given.name) : given.name;
        std::erase_if(selection.parameters, [&](const auto& named) { return named.first == parameter; });
    }
    Axis axis{given.name, {}, {given.argument, given.name}};
    for (const Json& value : given.values) {
        axis.values.push_back(resolve_axis_value(given.name, JsonView(value, given.argument, given.name), {"."}));
    }
    if (given.name == "albedo") drop_own_albedos(configuration);
    configuration.overridden.push_back(given.name);
    const auto earlier = std::ranges::find(configuration.axes, given.name, &Axis::name);
    if (earlier == configuration.axes.end()) {
        configuration.axes.push_back(std::move(axis));
    } else {
        *earlier = std::move(axis);
    }
}

void apply_overrides(const std::vector<Override>& parsed, Configuration& configuration,
                     const ManifestIndex& manifests) {
    for (auto given = parsed.begin(); given != parsed.end(); ++given) {
        const auto earlier = std::ranges::find(parsed, given->name, &Override::name);
        if (earlier != given) {
            fail("{}: '{}' is given twice, first as {}; give all its values at once", given->argument, given->name,
                 earlier->argument);
        }
    }
    // The selection first: it says whose parameters the others replace.
    for (const Override& given : parsed) {
        if (given.name == "technique") override_techniques(given, configuration, manifests);
    }
    for (const Override& given : parsed) {
        if (given.name == "preset") override_presets(given, configuration, manifests);
    }
    // Then albedos, which take the place of the configuration's height maps' own, but not of those given beside them.
    const auto override_axes = [&](bool albedos) {
        for (const Override& given : parsed) {
            if (given.name != "technique" && given.name != "preset" && (given.name == "albedo") == albedos)
                override_axis(given, configuration, manifests);
        }
    };
    override_axes(true);
    override_axes(false);
    untie(parsed, configuration);
}

Json selection_json(const TechniqueSelection& selection) {
    Json json = Json::object();
    json["technique"] = selection.technique;
    if (!selection.presets.empty()) json["preset"] = selection.presets;
    for (const auto& [name, values] : selection.parameters) {
        for (const ParameterValue& value : values)
            json["parameters"][name].push_back(to_json(value));
    }
    return json;
}

Json expanded_json(const Configuration& configuration) {
    Json json = Json::object();
    json["name"] = configuration.name;
    json["techniques"] = Json::array();
    for (const TechniqueSelection& selection : configuration.techniques) {
        json["techniques"].push_back(selection_json(selection));
    }
    json["axes"] = Json::object();
    for (const Axis& axis : configuration.axes)
        json["axes"][axis.name] = axis.values;
    json["zip"] = configuration.zip;
    json["exclude"] = configuration.exclude;
    json["seed"] = configuration.seed;
    json["truth"] = to_json(configuration.truth);
    json["sampling"] = to_json(configuration.sampling);
    json["preparation"] = to_json(configuration.preparation);
    json["lighting"] = to_json(configuration.lighting);
    if (configuration.object) json["object"] = to_json(*configuration.object);
    json["images"] = configuration.images;
    if (configuration.motion) json["motion"] = to_json(*configuration.motion);
    return json;
}

/// Of an axis `albedo` and a height map's own one would be left out, and nothing would tell.
void refuse_two_albedos(const Configuration& configuration) {
    const auto albedos = std::ranges::find(configuration.axes, "albedo", &Axis::name);
    const auto maps = std::ranges::find(configuration.axes, "heightmap", &Axis::name);
    if (albedos == configuration.axes.end() || maps == configuration.axes.end()) return;
    for (const Json& value : maps->values) {
        if (!value.is_object() || !value.contains("albedo")) continue;
        fail("{}: {}: a height map has an albedo of its own, {}; give either that or the axis albedo",
             albedos->origin.file, albedos->origin.path, value.at("albedo").dump());
    }
}

/// Several sizes swept over a file would look as if they were measured.
void warn_of_sizes_of_files(const Configuration& configuration) {
    const auto sizes = std::ranges::find(configuration.axes, "heightmap_size", &Axis::name);
    const auto maps = std::ranges::find(configuration.axes, "heightmap", &Axis::name);
    if (sizes == configuration.axes.end() || maps == configuration.axes.end()) return;
    for (const Json& value : maps->values) {
        const HeightMapValue map = read_height_map_value(JsonView(value, maps->origin.file, maps->origin.path));
        if (is_procedural(map.source.name)) continue;
        log_warning("{}: {}: heightmap_size is for procedural height maps; '{}' keeps its own size", sizes->origin.file,
                    sizes->origin.path, height_map_label(map.source));
    }
}

}  // namespace

namespace configuration_keys {

const std::vector<std::string>& top() {
    static const std::vector<std::string> keys{"$schema",  "name",   "techniques", "axes",     "zip",
                                               "exclude",  "seed",   "truth",      "sampling", "preparation",
                                               "lighting", "object", "images",     "motion"};
    return keys;
}

const std::vector<std::string>& technique() {
    static const std::vector<std::string> keys{"technique", "preset", "parameters"};
    return keys;
}

}  // namespace configuration_keys

Configuration parse_configuration(const Json& json, const std::string& file, const std::vector<std::string>& overrides,
                                  const std::vector<Manifest>& techniques) {
    std::vector<Override> parsed;
    for (const std::string& argument : overrides)
        parsed.push_back(parse_override(argument));
    return configuration_with(json, file, parsed, techniques);
}

Configuration configuration_with(const Json& json, const std::string& file, const std::vector<Override>& overrides,
                                 const std::vector<Manifest>& techniques) {
    const ManifestIndex manifests = index_manifests(techniques);
    const JsonView whole(json, file);
    const bool is_run = json.is_object() && json.contains("configuration") && json.at("configuration").is_object();
    Configuration configuration = read(is_run ? whole.at("configuration") : whole, manifests);
    // As it stands in the file, before overrides hide what is wrong with it.
    plan_sweep(configuration, techniques);
    apply_overrides(overrides, configuration, manifests);
    plan_sweep(configuration, techniques);
    refuse_two_albedos(configuration);
    warn_of_sizes_of_files(configuration);
    configuration.expanded = expanded_json(configuration);
    return configuration;
}

void set_sampling(Configuration& configuration, const std::vector<std::string>& settings) {
    for (const std::string& text : settings) {
        const std::string argument = "--sampling " + text;
        Json sampling = to_json(configuration.sampling);
        for (const std::string& part : split(text, ',')) {
            const std::size_t equals = part.find('=');
            if (equals == std::string::npos || equals == 0 || equals + 1 == part.size()) {
                fail("{}: expected name=value, as in rule=fixed,rounds=20; the settings are {}", argument,
                     join(configuration_keys::sampling()));
            }
            sampling[part.substr(0, equals)] = scalar_from_text(part.substr(equals + 1));
        }
        configuration.sampling = read_sampling(JsonView(sampling, argument, ""));
    }
    if (!settings.empty()) configuration.expanded["sampling"] = to_json(configuration.sampling);
}

void set_preparation_limit(Configuration& configuration, double limit_s) {
    configuration.preparation.limit_s = limit_s;
    configuration.expanded["preparation"] = to_json(configuration.preparation);
}

}  // namespace reliefbench
