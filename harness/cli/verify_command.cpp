#include "cli/command.hpp"
#include "cli/results.hpp"
#include "cli/shared_options.hpp"
#include "cli/shell_word.hpp"
#include "core/cache_folder.hpp"
#include "core/counted.hpp"
#include "sweep/configuration.hpp"
#include "verify/conformance.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>

namespace reliefbench {

namespace {

struct VerifyOptions {
    std::vector<std::string> techniques;
    TechniqueOptions library;
    DeviceChoice device;
    PreparationOptions preparation;
};

/// The command line that shows what a failed check drew.
std::string render_command(const Check& check, const Technique& technique, const VerifyOptions& options) {
    std::vector<std::string> words = render_words(technique.manifest, *check.drawn, check.technique + ".png");
    for (const std::string& directory : options.library.directories)
        words.insert(words.end(), {"--techniques", directory});
    if (!options.device.options.choice.empty()) words.insert(words.end(), {"--device", options.device.options.choice});
    std::string command = "reliefbench";
    for (const std::string& word : words)
        command += " " + shell_word(word);
    const std::string making = map_making_command(*check.drawn);
    return making.empty() ? command : making + " && " + command;
}

void print_check(const Check& check, const Technique* technique, const VerifyOptions& options) {
    const char* const word = check.passed ? "ok" : check.skipped ? "skip" : "FAIL";
    std::string line = fmt::format("{:<4}  {}: {}{}: {}", word, check.technique, check.name,
                                   check.circumstances.empty() ? "" : " (" + check.circumstances + ")", check.detail);
    if (check.failed() && check.drawn && technique) {
        if (const std::optional<PixelPlace>& worst = check.drawn->worst) {
            const std::string place = fmt::format("pixel ({}, {})", worst->column, worst->row);
            if (check.detail.find(place) == std::string::npos) line += "; worst at " + place;
        }
        line += "; to see it: " + render_command(check, *technique, options);
    }
    print_results(line + '\n');
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
    std::size_t passed = 0;
    std::size_t failed = 0;
    std::size_t skipped = 0;
    const auto count_check = [&](const Check& check, const Technique* technique) {
        print_check(check, technique, options);
        passed += check.passed ? 1 : 0;
        failed += check.failed() ? 1 : 0;
        skipped += check.skipped ? 1 : 0;
    };
    if (options.techniques.empty()) {
        for (const auto& [id, message] : library.broken) {
            count_check({.technique = id, .name = "manifest", .circumstances = {}, .detail = message}, nullptr);
        }
    }
    for (const Technique& technique : selected) {
        verify_technique(device, technique, [&](const Check& check) { count_check(check, &technique); },
                         {.limit_s = options.preparation.limit_s.value_or(PreparationSettings{}.limit_s),
                          .cache = cache_folder()});
    }
    print_results(fmt::format("{} of {} passed on {}{}\n", passed, counted(passed + failed, "check"),
                              device.info().name, skipped > 0 ? fmt::format(", {} skipped", skipped) : ""));
    return worse_of(failed > 0 ? ExitCode::cells_failed : ExitCode::done, check_validation(device));
}

}  // namespace

void add_verify_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = app.add_subcommand("verify", "Hold techniques to their promises on a device");
    add_repeated_option(*command, "--technique", options->techniques, "Only this one (may be repeated); default: all")
        ->type_name("ID");
    options->library.add_to(*command);
    options->device.add_to(*command);
    options->preparation.add_to(*command, "none");
    command->footer(
        "Exit code 0 when every check passes, 4 when one fails. What a run would skip or call failed is so here, with "
        "the\n"
        "same words. A FAIL line names the worst pixel, (column, row) from\n"
        "the top left from 0, and the command that draws it.\n"
        "Example: reliefbench verify --technique my_march --techniques my_techniques\n");
    command->callback([&chosen, options] { chosen = [options] { return verify(*options); }; });
}

}  // namespace reliefbench
