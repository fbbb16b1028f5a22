#include "cli/command.hpp"
#include "cli/results.hpp"
#include "cli/shared_options.hpp"
#include "cli/stored_runs.hpp"
#include "cli/terminal.hpp"
#include "cli/threshold.hpp"
#include "compare/common_ids.hpp"
#include "compare/history.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "report/history_format.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace reliefbench {

namespace {

/// Three before a change and three after it.
constexpr std::size_t min_runs = 6;

struct HistoryCommandOptions {
    std::vector<std::string> folders;
    std::vector<std::string> cells;
    std::string threshold = "2%";
    std::string format = "table";
};

std::string time_of(const StoredRun& run) {
    const auto environment = run.run.run.find("environment");
    if (environment == run.run.run.end() || !environment->is_object()) return "";
    return environment->value("time", "");
}

/// A shell sorts run10 before run2.
void warn_of_disorder(const std::vector<StoredRun>& runs) {
    for (std::size_t run = 1; run < runs.size(); ++run) {
        const std::string before = time_of(runs[run - 1]);
        const std::string time = time_of(runs[run]);
        if (!before.empty() && !time.empty() && time < before) {
            log_warning("{} ({}) is older than {} ({}), which stands before it; name the runs in their order",
                        runs[run].name, time, runs[run - 1].name, before);
            return;
        }
    }
}

ExitCode show_history(const HistoryCommandOptions& options) {
    const HistoryFormat format = parse_history_format(options.format);
    HistoryOptions history_options;
    history_options.minimum_effect = parse_threshold(options.threshold, "--threshold");
    std::vector<StoredRun> runs = read_stored_runs(options.folders);
    give_common_ids(runs);
    keep_cells(runs, options.cells);
    warn_of_disorder(runs);
    if (runs.size() < min_runs) {
        log_warning("{} {} too few for change points: at least three stand before one and three after it",
                    counted(runs.size(), "run"), runs.size() == 1 ? "is" : "are");
    }
    print_results(format_history(make_history(runs, history_options), format, table_columns()));
    return ExitCode::done;
}

}  // namespace

void add_history_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<HistoryCommandOptions>();
    CLI::App* command =
        app.add_subcommand("history", "The times of a series of runs, with the points where they changed");
    command->add_option("runs", options->folders, "Folders of runs, the oldest first")->required()->type_name("RUN");
    add_repeated_option(*command, "--cell", options->cells,
                        "Only cells whose id contains this (may be repeated; any may match)")
        ->type_name("TEXT");
    command
        ->add_option("--threshold", options->threshold,
                     "The smallest step of time that matters, written 2% or 0.02; default: 2%")
        ->type_name("FRACTION");
    command->add_option("--format", options->format, "How to write the result; default: table")
        ->type_name(join(history_format_names(), "|"));
    command->footer(
        "Runs are counted from 1. Exit code 0, whatever changed: `compare` judges.\n"
        "Example: reliefbench history results/2026-* --cell pom\n");
    command->callback([&chosen, options] { chosen = [options] { return show_history(*options); }; });
}

}  // namespace reliefbench
