#include "cli/command.hpp"
#include "cli/results.hpp"
#include "cli/shared_options.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/text_layout.hpp"
#include "scene/image_file.hpp"
#include "scene/procedural.hpp"
#include "store/figures.hpp"

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

void print_technique(const Technique& technique) {
    const Manifest& manifest = technique.manifest;
    fmt::print("{:<14} {} ({})\n", manifest.id, manifest.title, manifest.kind);
    for (const Parameter& parameter : manifest.parameters) {
        const bool is_sample_count = manifest.sample_count == parameter.name;
        fmt::print("    {:<18} {:<12} {:<24} {}{}\n", parameter.name, to_string(parameter.default_value),
                   allowed_values(parameter), parameter.help, is_sample_count ? " [the axis sample_count]" : "");
    }
    std::vector<std::string> promises;
    for (const PromiseDeclaration& declaration : manifest.promises) {
        promises.push_back(to_string(declaration.promise));
    }
    if (!promises.empty()) fmt::print("    promises: {}\n", join(promises));
}

ExitCode list_techniques(const TechniqueOptions& options) {
    const TechniqueLibrary library = options.find();
    for (const Technique& technique : library.techniques) {
        print_technique(technique);
    }
    for (const auto& [id, message] : library.broken) {
        fmt::print("{:<14} cannot be used: {}\n", id, message);
    }
    return ExitCode::done;
}

ExitCode list_devices() {
    for (const gpu::DeviceInfo& device : gpu::list_devices()) {
        fmt::print("{}  {} ({}, {} {}, Vulkan {}){}\n", device.index, device.name, to_string(device.type),
                   device.driver, device.driver_version, device.api_version,
                   device.unusable_reason.empty() ? "" : ": cannot be used: " + device.unusable_reason);
    }
    return ExitCode::done;
}

ExitCode list_height_maps() {
    for (const ProceduralMap& map : procedural_maps()) {
        fmt::print("{:<12} {}\n", map.name, map.description);
    }
    fmt::print("or the path of {}\n", readable_images());
    return ExitCode::done;
}

std::string figures_as_table() {
    constexpr std::string_view no_unit = "-";
    std::size_t path_width = 0;
    std::size_t unit_width = 0;
    for (const FigureDeclaration& figure : figures()) {
        path_width = std::max(path_width, text_width(figure.path));
        unit_width = std::max(unit_width, text_width(figure.unit));
    }
    const std::size_t better_width = text_width(to_string(Better::neither));
    std::string text;
    for (const FigureDeclaration& figure : figures()) {
        text += fmt::format("{}  {}  {}  {}\n", pad_right(figure.path, path_width),
                            pad_right(figure.unit.empty() ? no_unit : figure.unit, unit_width),
                            pad_right(to_string(figure.better), better_width), figure.label);
    }
    return text;
}

/// One figure a line.
std::string figures_as_json() {
    std::vector<std::string> lines;
    for (const Json& figure : figures_to_json()) {
        lines.push_back("  " + figure.dump());
    }
    return "[\n" + join(lines, ",\n") + "\n]\n";
}

const std::vector<std::string>& figure_format_names() {
    static const std::vector<std::string> names = {"table", "json"};
    return names;
}

ExitCode list_figures(const std::string& format) {
    const std::vector<std::string>& names = figure_format_names();
    if (std::find(names.begin(), names.end(), format) == names.end()) {
        fail("--format: there is no '{}'{}; the formats are {}", format, did_you_mean(format, names), join(names));
    }
    print_results(format == "json" ? figures_as_json() : figures_as_table());
    return ExitCode::done;
}

}  // namespace

void add_list_command(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* list = app.add_subcommand("list", "List what there is to choose from");
    list->require_subcommand(1);
    list->footer("Example: reliefbench list techniques\n");

    const auto options = std::make_shared<TechniqueOptions>();
    CLI::App* techniques = list->add_subcommand(
        "techniques", "Techniques: id, title (kind); parameters with default, values and meaning; promises");
    techniques->footer("Example: reliefbench list techniques --techniques my_techniques\n");
    options->add_to(*techniques);
    techniques->callback([&chosen, options] { chosen = [options] { return list_techniques(*options); }; });

    CLI::App* devices = list->add_subcommand("devices", "Vulkan devices: index, name (type, driver, version)");
    devices->footer("Example: reliefbench list devices\n");
    devices->callback([&chosen] { chosen = list_devices; });

    CLI::App* height_maps = list->add_subcommand("heightmaps", "Procedural height maps");
    height_maps->footer("Example: reliefbench list heightmaps\n");
    height_maps->callback([&chosen] { chosen = list_height_maps; });

    CLI::App* listed_figures =
        list->add_subcommand("figures", "Figures of a cell: name in its files, unit, which way is better, label");
    const auto format = std::make_shared<std::string>("table");
    listed_figures->add_option("--format", *format, "How to write the list; default: table")
        ->type_name(join(figure_format_names(), "|"));
    listed_figures->footer("Example: reliefbench list figures\n");
    listed_figures->callback([&chosen, format] { chosen = [format] { return list_figures(*format); }; });
}

}  // namespace reliefbench
