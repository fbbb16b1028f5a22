#include "cli/shared_options.hpp"

#include "core/log.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace reliefbench {

void TechniqueOptions::add_to(CLI::App& command) {
    add_repeated_option(command, "--techniques", directories,
                        "A directory of technique folders, beside those shipped (may be repeated)")
        ->type_name("DIR");
}

TechniqueLibrary TechniqueOptions::find() const {
    std::vector<std::filesystem::path> roots{default_technique_root()};
    roots.insert(roots.end(), directories.begin(), directories.end());
    return find_techniques(roots);
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

void PreparationOptions::add_to(CLI::App& command) {
    command
        .add_option("--preparation-limit", limit_s,
                    "Skip what would take longer to prepare than so many seconds on the device; "
                    "default: the configuration's preparation.limit_s, else 60")
        ->check(CLI::NonNegativeNumber)
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
