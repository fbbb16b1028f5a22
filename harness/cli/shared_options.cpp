#include "cli/shared_options.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "core/number_text.hpp"
#include "core/suggest.hpp"
#include "sweep/configuration_keys.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace reliefbench {

void TechniqueOptions::add_to(CLI::App& command) {
    add_repeated_option(command, "--techniques", directories,
                        "A directory of technique folders, beside those shipped; one of the same name takes a shipped "
                        "one's place (may be repeated)")
        ->type_name("DIR");
}

TechniqueLibrary TechniqueOptions::find() const {
    check();
    return find_in(directories);
}

void TechniqueOptions::check() const {
    for (const std::string& directory : directories) {
        if (const std::string complaint = complaint_of_root(directory); !complaint.empty())
            fail("--techniques: {}", complaint);
    }
}

TechniqueLibrary TechniqueOptions::find_in(const std::vector<std::string>& directories) {
    std::vector<std::filesystem::path> roots{default_technique_root()};
    roots.insert(roots.end(), directories.begin(), directories.end());
    TechniqueLibrary library = find_techniques(roots, shader_root());
    for (const Technique& technique : library.techniques) {
        if (takes_place_of_shipped(technique)) {
            log_warning("{} takes the place of the shipped technique '{}'", technique.folder.string(),
                        technique.manifest.id);
        }
    }
    return library;
}

void CellChoice::add_to(CLI::App& command) {
    add_repeated_option(command, "-a,--axis", axes,
                        "Values of an axis or parameter (see `list axes`, `list techniques`) in place of the "
                        "configuration's: name=v1,v2 or name=[start:stop:step], and as JSON where a value has a comma: "
                        "name=[\"a,b.png\"] (may be repeated)")
        ->type_name("NAME=VALUES");
    add_repeated_option(command, "--filter", filters,
                        "Keep only cells that fulfil this: technique=pom,qdm, view_angle>=60; values as for -a (may be "
                        "repeated; all must hold)")
        ->type_name("EXPR");
}

void SamplingChoice::add_to(CLI::App& command) {
    add_repeated_option(command, "--sampling", settings,
                        "Settings in place of those of the configuration's \"sampling\": rule=fixed,rounds=20 (" +
                            join(configuration_keys::sampling()) + "; may be repeated)")
        ->type_name("NAME=VALUE,...");
}

void DeviceChoice::add_to(CLI::App& command) {
    command
        .add_option("--device", options.choice,
                    "Index or (part of the) name of the Vulkan device, see `list devices`; "
                    "default: RELIEFBENCH_DEVICE, else the best there is")
        ->type_name("N|NAME");
    command.add_flag("--validate", options.validation,
                     "Turn the Vulkan validation layer on; one message makes the command fail");
}

void PreparationOptions::add_to(CLI::App& command, const std::string& otherwise) {
    command
        .add_option("--preparation-limit", limit_s,
                    "Skip what would take longer to prepare than so many seconds on the device; "
                    "default: " +
                        otherwise)
        ->check([](const std::string& text) {
            const std::optional<double> seconds = whole_text_as<double>(text);
            return seconds && *seconds >= 0 ? "" : fmt::format("expected a number of at least 0, found '{}'", text);
        })
        ->type_name("SECONDS");
}

ExitCode check_validation(const gpu::Device& device) {
    const std::vector<std::string> messages = device.validation_messages();
    for (const std::string& message : messages) {
        log_error("validation layer: {}", message);
    }
    return messages.empty() ? ExitCode::done : ExitCode::internal_error;
}

CLI::Option* add_repeated_option(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                                 const std::string& help) {
    return command.add_option(name, values, help)->expected(1)->take_all()->allow_extra_args(false);
}

}  // namespace reliefbench
