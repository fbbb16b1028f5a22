#include "cli/command.hpp"
#include "cli/completion.hpp"
#include "cli/man_page.hpp"
#include "cli/results.hpp"
#include "sweep/view_axes.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace reliefbench {

namespace {

/// What `-a` and `--filter` take first.
std::vector<std::string> setting_names() {
    std::vector<std::string> names{"technique", "preset", "sample_count"};
    for (const ViewAxis& axis : view_axes()) {
        names.push_back(axis.name);
    }
    return names;
}

}  // namespace

void add_completion_command(CLI::App& app, ChosenCommand& chosen) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("completion", "Print a script by which a shell completes commands");
    command->add_option("shell", *shell, "Which shell")
        ->required()
        ->type_name("bash|zsh")
        ->check(CLI::IsMember({"bash", "zsh"}).description(""));
    command->footer(
        "`cmake --install` puts both where the shells look for them.\n"
        "Example: source <(reliefbench completion bash)\n"
        "Example: reliefbench completion zsh > ~/.zfunc/_reliefbench\n");
    command->callback([&app, &chosen, shell] {
        chosen = [&app, shell] {
            const CommandDescription program = describe_commands(app);
            print_results(*shell == "bash" ? bash_completion(program, setting_names())
                                           : zsh_completion(program, setting_names()));
            return ExitCode::done;
        };
    });
}

void add_man_command(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("man", "Print the manual page, in roff");
    command->footer("Example: reliefbench man | man -l -\n");
    command->callback([&app, &chosen] {
        chosen = [&app] {
            print_results(man_page(describe_commands(app), RELIEFBENCH_VERSION));
            return ExitCode::done;
        };
    });
}

}  // namespace reliefbench
