#include "cli/command.hpp"
#include "cli/shared_options.hpp"
#include "technique/map_cache.hpp"
#include "verify/conformance.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <memory>

namespace reliefbench {

namespace {

struct VerifyOptions {
    std::vector<std::string> techniques;
    TechniqueOptions library;
    DeviceChoice device;
};

void print_check(const Check& check) {
    fmt::print("{:<4}  {}: {}{}: {}\n", check.passed ? "ok" : "FAIL", check.technique, check.name,
               check.circumstances.empty() ? "" : " (" + check.circumstances + ")", check.detail);
    std::fflush(stdout);
}

std::vector<Technique> select(const TechniqueLibrary& library, const std::vector<std::string>& ids) {
    if (ids.empty()) return library.techniques;
    std::vector<Technique> selected;
    for (const std::string& id : ids) {
        selected.push_back(library.get(id));
    }
    return selected;
}

ExitCode verify(const VerifyOptions& options) {
    const TechniqueLibrary library = options.library.find();
    const std::vector<Technique> selected = select(library, options.techniques);
    const gpu::Device device(options.device.options);
    std::size_t checks = 0;
    std::size_t failures = 0;
    const auto on_check = [&](const Check& check) {
        print_check(check);
        ++checks;
        failures += check.passed ? 0 : 1;
    };
    if (options.techniques.empty()) {
        for (const auto& [id, message] : library.broken) {
            on_check({id, "manifest", "", false, message});
        }
    }
    for (const Technique& technique : selected) {
        verify_technique(device, technique, on_check, {.cache = map_cache_folder()});
    }
    fmt::print("{} of {} checks passed on {}\n", checks - failures, checks, device.info().name);
    return graver(failures > 0 ? ExitCode::cells_failed : ExitCode::done, check_validation(device));
}

}  // namespace

void add_verify_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = app.add_subcommand("verify", "Hold techniques to their promises on a device");
    add_repeated_option(*command, "--technique", options->techniques, "Only this one (may be repeated); default: all")
        ->type_name("ID");
    options->library.add_to(*command);
    options->device.add_to(*command);
    command->footer(
        "Exit code 0 when every check passes, 4 when one fails.\n"
        "Example: reliefbench verify --technique my_march --techniques my_techniques\n");
    command->callback([&chosen, options] { chosen = [options] { return verify(*options); }; });
}

}  // namespace reliefbench
