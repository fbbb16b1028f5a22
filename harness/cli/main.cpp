#include "cli/command.hpp"
#include "cli/help_formatter.hpp"
#include "cli/interrupt.hpp"
#include "cli/results.hpp"
#include "cli/run_sides.hpp"
#include "cli/usage_complaint.hpp"
#include "core/error.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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
    } catch (const Interrupted& interrupted) {
        std::fflush(stdout);
        end_by_signal(interrupted.signal);
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
    // A file that may not grow (ulimit -f) is a failed write, which is told, not the end.
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App app{"Measures techniques for drawing surface relief: GPU time against error from the ground truth.",
                 "reliefbench"};
    app.formatter(std::make_shared<HelpFormatter>());  // before commands, which take it over
    app.set_version_flag("--version", RELIEFBENCH_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, nothing worse; 1 a regression was found; 2 usage, configuration or input error;\n"
        "  3 undecided; 4 some cells or checks failed; 5 internal error. What is interrupted ends by the signal.\n"
        "Environment: RELIEFBENCH_DEVICE, the device unless --device says otherwise; RELIEFBENCH_DATA_DIR, the folder\n"
        "  of techniques/, configs/ and harness/shaders/; RELIEFBENCH_STATE_DIR, where what `selfcheck` finds is "
        "kept;\n"
        "  RELIEFBENCH_SHARE_DEVICE=1, as --share-device; RELIEFBENCH_MEMORY_MB, memory that a cell may take, in place "
        "of\n"
        "  what is available; NO_COLOR, no colours.\n"
        "`reliefbench COMMAND --help` shows the options of a command and an example.\n");
    ChosenCommand chosen;
    add_list_command(app, chosen);
    add_run_command(app, chosen, {argv, argv + argc});
    add_render_command(app, chosen);
    add_verify_command(app, chosen);
    add_ab_command(app, chosen);
    add_selfcheck_command(app, chosen);
    add_compare_command(app, chosen);
    add_history_command(app, chosen);
    add_export_command(app, chosen);
    add_advise_command(app, chosen, {argv, argv + argc});
    add_report_command(app, chosen);
    add_merge_command(app, chosen);
    add_bench_command(app, chosen);
    add_completion_command(app, chosen);
    add_man_command(app, chosen);
    try {
        std::vector<std::string> arguments = keep_separator({argv + 1, argv + argc});
        std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        const bool asked_for_help = error.get_exit_code() == 0;
        if (!asked_for_help) {
            fmt::print(stderr, "reliefbench: {}\n", usage_complaint(app, error));
            return static_cast<int>(ExitCode::bad_input);
        }
        chosen = [&app, &error] {
            std::ostringstream help;
            app.exit(error, help, help);
            print_results(help.str());
            return ExitCode::done;
        };
        return static_cast<int>(execute(chosen));
    }
    return static_cast<int>(execute(chosen));
}
