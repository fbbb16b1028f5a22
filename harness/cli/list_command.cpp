#include "cli/command.hpp"
#include "cli/results.hpp"
#include "cli/shared_options.hpp"
#include "core/error.hpp"
#include "core/json_lookup.hpp"
#include "core/suggest.hpp"
#include "report/markdown.hpp"
#include "report/text_layout.hpp"
#include "scene/image_file.hpp"
#include "scene/procedural.hpp"
#include "store/figures.hpp"
#include "sweep/base_value.hpp"
#include "sweep/view_axes.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace reliefbench {

namespace {

std::string allowed_values(const Parameter& parameter) {
    switch (parameter.type) {
        case ParameterType::boolean:
            return "false|true";
        case ParameterType::choice:
            return join(parameter.choices, "|");
        case ParameterType::integer:
        case ParameterType::real:
            return fmt::format("{}..{}", parameter.minimum, parameter.maximum);
    }
    return {};
}

std::string technique_lines(const Technique& technique) {
    const Manifest& manifest = technique.manifest;
    std::string lines = fmt::format("{:<14} {} ({})\n", manifest.id, manifest.title, manifest.kind);
    for (const Parameter& parameter : manifest.parameters) {
        const bool is_sample_count = manifest.sample_count == parameter.name;
        lines +=
            fmt::format("    {:<18} {:<12} {:<24} {}{}\n", parameter.name, to_string(parameter.default_value),
                        allowed_values(parameter), parameter.help, is_sample_count ? " [the axis sample_count]" : "");
    }
    if (!manifest.map_needs.empty()) {
        std::vector<std::string> needs;
        for (const MapNeed need : manifest.map_needs) {
            needs.push_back(to_string(need));
        }
        lines += fmt::format("    needs of the height map: {}\n", join(needs));
    }
    if (manifest.shadow_search == ShadowSearch::own) lines += "    hard shadows: by its own search\n";
    std::vector<std::string> promises;
    for (const PromiseDeclaration& declaration : manifest.promises) {
        promises.push_back(to_string(declaration.promise));
    }
    if (!promises.empty()) lines += fmt::format("    promises: {}\n", join(promises));
    return lines;
}

ExitCode list_techniques(const TechniqueOptions& options) {
    const TechniqueLibrary library = options.find();
    for (const Technique& technique : library.techniques) {
        print_results(technique_lines(technique));
    }
    for (const auto& [id, message] : library.broken) {
        print_results(fmt::format("{:<14} cannot be used: {}\n", id, message));
    }
    return ExitCode::done;
}

ExitCode list_devices() {
    for (const gpu::DeviceInfo& device : gpu::list_devices()) {
        print_results(fmt::format("{}  {} ({}, {} {}, Vulkan {}){}\n", device.index, device.name,
                                  to_string(device.type), device.driver, device.driver_version, device.api_version,
                                  device.unusable_reason.empty() ? "" : ": cannot be used: " + device.unusable_reason));
    }
    return ExitCode::done;
}

ExitCode list_height_maps() {
    for (const ProceduralMap& map : procedural_maps()) {
        print_results(fmt::format("{:<12} {}\n", map.name, map.description));
    }
    print_results(fmt::format("or the path of {}\n", readable_images()));
    return ExitCode::done;
}

/// A list in columns.
struct ListTable {
    std::vector<std::string> titles;
    std::vector<std::vector<std::string>> rows;
    /// Columns of code, from the left.
    std::size_t code_columns = 1;
    /// Below the rows on a terminal.
    std::string note = {};
};

constexpr std::string_view nothing_there = "-";

/// Columns as wide as their widest text, which is `nothing_there` where it is empty.
std::string columns_text(std::vector<std::vector<std::string>> rows) {
    std::vector<std::size_t> widths;
    for (std::vector<std::string>& row : rows) {
        widths.resize(row.size());
        for (std::size_t column = 0; column < row.size(); ++column) {
            if (row[column].empty()) row[column] = nothing_there;
            widths[column] = std::max(widths[column], text_width(row[column]));
        }
    }
    std::string text;
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t column = 0; column + 1 < row.size(); ++column)
            text += pad_right(row[column], widths[column]) + "  ";
        text += row.back() + '\n';
    }
    return text;
}

std::string markdown_of(const ListTable& table) {
    std::vector<std::vector<std::string>> rows = table.rows;
    for (std::vector<std::string>& row : rows) {
        for (std::size_t column = 0; column < row.size(); ++column)
            row[column] = column < table.code_columns ? markdown_code(row[column]) : markdown_text(row[column]);
    }
    return markdown_table(table.titles, std::string(table.titles.size(), 'l'), rows);
}

/// One entry a line.
std::string lines_of_json(const Json& entries) {
    if (entries.empty()) return "[]\n";
    std::vector<std::string> lines;
    for (const Json& entry : entries)
        lines.push_back("  " + entry.dump());
    return "[\n" + join(lines, ",\n") + "\n]\n";
}

const std::vector<std::string>& list_format_names() {
    static const std::vector<std::string> names = {"table", "json", "markdown"};
    return names;
}

void print_list(const ListTable& table, const Json& json, const std::string& format) {
    const std::vector<std::string>& names = list_format_names();
    if (std::find(names.begin(), names.end(), format) == names.end()) {
        fail("--format: there is no '{}'{}; the formats are {}", format, did_you_mean(format, names), join(names));
    }
    if (format == "json") {
        print_results(lines_of_json(json));
    } else if (format == "markdown") {
        print_results(markdown_of(table));
    } else {
        print_results(columns_text(table.rows) + table.note);
    }
}

ExitCode list_figures(const std::string& format) {
    ListTable table{.titles = {"Figure", "Unit", "Better", "Needs", "What it is"}, .rows = {}};
    for (const FigureDeclaration& figure : figures())
        table.rows.push_back(
            {figure.path, figure.unit, std::string(to_string(figure.better)), join(figure.needs, " "), figure.label});
    print_list(table, figures_to_json(), format);
    return ExitCode::done;
}

ExitCode list_axes(const std::string& format) {
    ListTable table{.titles = {"Axis", "Unit", "Default", "Values", "What it is"},
                    .rows = {},
                    .note = "and every parameter of a technique, and `technique` itself: see `list techniques`\n"};
    const Json axes = axis_list_json();
    for (const Json& axis : axes) {
        const Json& usual = axis.at("default");
        const auto text = [&axis](const char* key) { return axis.at(key).get<std::string>(); };
        table.rows.push_back({text("axis"), text("unit"), usual.is_null() ? "" : scalar_text(usual), text("values"),
                              text("description")});
    }
    print_list(table, axes, format);
    return ExitCode::done;
}

ExitCode list_bases(const std::string& format) {
    ListTable table{.titles = {"Base", "Axes", "Limits", "What it is"},
                    .rows = {},
                    .note = "curvature is in 1/patch side, positive away from the viewer; see docs/bases.md\n"};
    const Json bases = base_list_json();
    for (const Json& base : bases) {
        const auto text = [&base](const char* key) { return base.at(key).get<std::string>(); };
        table.rows.push_back({text("base"), join(base.at("axes").get<std::vector<std::string>>(), " "), text("limits"),
                              text("description")});
    }
    print_list(table, bases, format);
    return ExitCode::done;
}

std::string parameters_text(const ParameterValues& values) {
    std::vector<std::string> parts;
    for (const auto& [name, value] : values)
        parts.push_back(name + '=' + to_string(value));
    return join(parts, " ");
}

Json preset_json(const Manifest& manifest, const Preset& preset) {
    Json json{{"preset", preset.name}, {"technique", manifest.id}};
    json.update(to_json(preset));
    return json;
}

ExitCode list_presets(const TechniqueOptions& options, const std::string& format) {
    ListTable table{.titles = {"Preset", "Technique", "Of", "Parameters", "Source", "Not expressed"},
                    .rows = {},
                    .code_columns = 2,
                    .note =
                        "in a configuration {\"technique\": ..., \"preset\": ...}, on the command line -a preset=...; "
                        "--format json has sources and what no parameter expresses\n"};
    Json presets = Json::array();
    for (const Technique& technique : options.find().techniques) {
        const Manifest& manifest = technique.manifest;
        for (const Preset& preset : manifest.presets) {
            std::vector<std::string> row{preset.name, manifest.id, preset.title, parameters_text(preset.parameters)};
            // Long lines, which no terminal shows side by side.
            if (format != "table") row.insert(row.end(), {preset.source, preset.not_expressed});
            table.rows.push_back(std::move(row));
            presets.push_back(preset_json(manifest, preset));
        }
    }
    print_list(table, presets, format);
    return ExitCode::done;
}

/// A list of its own with `--format`.
void add_formatted_list(CLI::App& list, ChosenCommand& chosen, const std::string& name, const std::string& help,
                        ExitCode (*print)(const std::string& format)) {
    CLI::App* command = list.add_subcommand(name, help);
    const auto format = std::make_shared<std::string>("table");
    command->add_option("--format", *format, "How to write the list; default: table")
        ->type_name(join(list_format_names(), "|"));
    command->footer("Example: reliefbench list " + name + "\n");
    command->callback([&chosen, format, print] { chosen = [format, print] { return print(*format); }; });
}

}  // namespace

void add_list_command(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* list = app.add_subcommand("list", "List what there is to choose from");
    list->require_subcommand(1);
    list->footer("Example: reliefbench list techniques\n");

    const auto options = std::make_shared<TechniqueOptions>();
    CLI::App* techniques = list->add_subcommand(
        "techniques", "Techniques: id, title (kind); parameters with default, values and meaning; needs; promises");
    techniques->footer("Example: reliefbench list techniques --techniques my_techniques\n");
    options->add_to(*techniques);
    techniques->callback([&chosen, options] { chosen = [options] { return list_techniques(*options); }; });

    CLI::App* devices = list->add_subcommand("devices", "Vulkan devices: index, name (type, driver, version)");
    devices->footer("Example: reliefbench list devices\n");
    devices->callback([&chosen] { chosen = list_devices; });

    CLI::App* height_maps = list->add_subcommand("heightmaps", "Procedural height maps");
    height_maps->footer("Example: reliefbench list heightmaps\n");
    height_maps->callback([&chosen] { chosen = list_height_maps; });

    add_formatted_list(*list, chosen, "axes", "Axes of a sweep: name, unit, default, values, meaning", list_axes);
    add_formatted_list(*list, chosen, "bases", "Bases that the relief may lie on: name, axes, limits, meaning",
                       list_bases);
    const auto library = std::make_shared<TechniqueOptions>();
    const auto preset_format = std::make_shared<std::string>("table");
    CLI::App* presets = list->add_subcommand(
        "presets", "Settings of engines and publications: name, technique, whose, parameters, source");
    library->add_to(*presets);
    presets->add_option("--format", *preset_format, "How to write the list; default: table")
        ->type_name(join(list_format_names(), "|"));
    presets->footer("Example: reliefbench list presets --format json\n");
    presets->callback([&chosen, library, preset_format] {
        chosen = [library, preset_format] { return list_presets(*library, *preset_format); };
    });

    add_formatted_list(*list, chosen, "figures",
                       "Figures of a cell: name in its files, unit, which way is better, what it needs, label",
                       list_figures);
}

}  // namespace reliefbench
