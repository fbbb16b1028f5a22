#include "cli/run_sources.hpp"

#include "core/json.hpp"
#include "core/log.hpp"
#include "store/run_folder.hpp"
#include "store/stored_format.hpp"
#include "sweep/override.hpp"
#include "sweep/override_effects.hpp"
#include "sweep/recorded_defaults.hpp"

#include <algorithm>
#include <filesystem>

namespace reliefbench {

namespace {

/// Every word of a "techniques" value, whatever its form: among them are the ids that it names.
void collect_words(const Json& value, std::vector<std::string>& words) {
    if (value.is_string()) {
        words.push_back(value.get<std::string>());
    }
    if (value.is_structured()) {
        for (const Json& element : value) {
            collect_words(element, words);
        }
    }
}

/// The strings of an optional array of run.json.
std::vector<std::string> recorded_strings(const JsonView& record, const std::string& key) {
    std::vector<std::string> strings;
    if (record.has(key)) {
        for (const JsonView& item : record.at(key).items()) {
            strings.push_back(item.string());
        }
    }
    return strings;
}

std::optional<Shard> recorded_shard(const JsonView& record) {
    if (!record.has("shard")) return std::nullopt;
    const JsonView shard = record.at("shard");
    return parse_shard(fmt::format("{}/{}", shard.at("index").integer(), shard.at("count").integer()));
}

std::vector<std::string> absolute_paths(const std::vector<std::string>& directories) {
    std::vector<std::string> paths;
    for (const std::string& directory : directories) {
        const std::string path = std::filesystem::absolute(directory).lexically_normal().string();
        if (std::find(paths.begin(), paths.end(), path) == paths.end()) {
            paths.push_back(path);
        }
    }
    return paths;
}

std::vector<std::string> overridden_names(const std::vector<std::string>& arguments) {
    std::vector<std::string> names;
    for (const std::string& argument : arguments)
        names.push_back(parse_override(argument).name);
    return names;
}

/// Of the run whose run.json this is: what it records, else what the cells beside it show. A record that came by a pipe
/// has no cells beside it.
Json recorded_defaults(const Json& record, const std::filesystem::path& file) {
    Run run{.run = record, .cells = {}};
    std::error_code ignored;
    const bool has_folder = file.filename() == "run.json" && std::filesystem::is_regular_file(file, ignored);
    if (!record.contains("defaults") && has_folder) run.cells = read_first_cells(file.parent_path());
    Json recorded = defaults_of(run);
    if (record.contains("presets")) recorded["presets"] = record.at("presets");
    return recorded;
}

/// Of techniques that have a cell.
void report_changed_defaults(const RepeatedConfiguration& repeated, const std::vector<Cell>& cells,
                             const std::string& file) {
    const auto has_cell = [&cells](const std::string& technique) {
        return technique.empty() ||
               std::ranges::any_of(cells, [&](const Cell& cell) { return cell.technique == technique; });
    };
    for (const ChangedDefault& change : repeated.changes) {
        if (has_cell(change.technique)) log_warning("{}: repeated as it was run, with {}", file, change.text);
    }
    for (const std::string& technique : repeated.unknown) {
        if (!has_cell(technique)) continue;
        log_warning(
            "{}: what the parameters of {} were by default is neither recorded nor to be seen in its cells; they "
            "are what they are by default now",
            file, technique);
    }
}

/// Warns of technique folders that cannot be used. One that the configuration names is an Error.
void report_broken_techniques(const TechniqueLibrary& library, const std::vector<std::string>& named) {
    for (const auto& [id, message] : library.broken) {
        if (std::find(named.begin(), named.end(), id) != named.end()) {
            library.get(id);
        }
        log_warning("technique '{}' cannot be used: {}", id, message);
    }
}

}  // namespace

RunSources read_run_sources(const ConfigurationText& text, const CellChoice& choice,
                            const TechniqueOptions& techniques) {
    Json file = parse_json(text.text, text.file);
    const bool is_record = file.is_object() && file.contains("configuration");
    const Json& configuration = is_record ? file.at("configuration") : file;

    RunSources sources;
    std::vector<std::string> directories = techniques.directories;
    if (is_record) {
        const JsonView record(file, text.file);
        format_of(record);
        sources.filters = recorded_strings(record, "filters");
        const std::vector<std::string> recorded = recorded_strings(record, "technique_directories");
        directories.insert(directories.end(), recorded.begin(), recorded.end());
        sources.shard = recorded_shard(record);
    }
    sources.filters.insert(sources.filters.end(), choice.filters.begin(), choice.filters.end());
    sources.technique_directories = absolute_paths(directories);
    techniques.check();
    sources.library = TechniqueOptions::find_in(sources.technique_directories);

    std::vector<std::string> named;
    if (configuration.is_object() && configuration.contains("techniques")) {
        collect_words(configuration.at("techniques"), named);
    }
    report_broken_techniques(sources.library, named);
    const std::vector<Manifest> manifests = sources.library.manifests();
    RepeatedConfiguration repeated;
    if (is_record) {
        repeated = with_recorded_defaults(file.at("configuration"), recorded_defaults(file, text.file), manifests,
                                          overridden_names(choice.axes));
        file["configuration"] = std::move(repeated.configuration);
    }
    sources.configuration = parse_configuration(file, text.file, choice.axes, manifests);
    sources.cells = filter_cells(expand(sources.configuration, manifests), sources.filters, manifests);
    warn_of_overrides(sources.configuration, sources.cells, manifests);
    report_changed_defaults(repeated, sources.cells, text.file);
    return sources;
}

}  // namespace reliefbench
