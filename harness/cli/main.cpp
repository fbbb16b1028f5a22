#include "cli/command.hpp"
#include "core/error.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace {

using namespace reliefbench;

/// stdout carries the results: losing them to a full disk or a closed pipe is a failure too.
void flush_results() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        fail("cannot write the results to standard output; is the disk full?");
    }
}

ExitCode execute(const ChosenCommand& chosen) {
    try {
        const ExitCode code = chosen();
        flush_results();
        return code;
    } catch (const Error& error) {
        fmt::print(stderr, "reliefbench: {}\n", error.what());
        return ExitCode::bad_input;
    } catch (const std::exception& error) {
        fmt::print(stderr, "reliefbench: internal error: {}; please report it with the command line\n", error.what());
        return ExitCode::internal_error;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Measures techniques for drawing surface relief: GPU time against error from the ground truth."};
    app.set_version_flag("--version", RELIEFBENCH_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done; 2 usage, configuration or input error; 4 some cells or checks failed; 5 internal error.\n"
        "`reliefbench COMMAND --help` shows the options of a command and an example.\n");
    ChosenCommand chosen;
    add_list_command(app, chosen);
    add_run_command(app, chosen, {argv, argv + argc});
    add_render_command(app, chosen);
    add_verify_command(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked_for_help = error.get_exit_code() == 0;
        if (!asked_for_help) {
            fmt::print(stderr, "reliefbench: {}; see `reliefbench --help`\n", error.what());
            return static_cast<int>(ExitCode::bad_input);
        }
        return app.exit(error);
    }
    return static_cast<int>(execute(chosen));
}
