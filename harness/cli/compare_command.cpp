#include "cli/command.hpp"
#include "cli/comparison_choice.hpp"
#include "cli/comparison_output.hpp"
#include "cli/recorded_noise.hpp"
#include "cli/run_sides.hpp"
#include "cli/stored_runs.hpp"
#include "compare/common_ids.hpp"
#include "compare/compare_runs.hpp"
#include "compare/pair_runs.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <span>

namespace reliefbench {

namespace {

struct CompareCommandOptions {
    std::vector<std::string> folders;
    ComparisonChoice comparison;
    bool quality_only = false;
    ComparisonOutput output;
};

ExitCode compare(const CompareCommandOptions& options) {
    options.output.check();
    const RunSides sides = split_sides(options.folders, "compare");
    // Together, so that a run on both sides is found.
    std::vector<std::string> folders = sides.base;
    folders.insert(folders.end(), sides.changed.begin(), sides.changed.end());
    std::vector<StoredRun> runs = read_stored_runs(folders);
    give_common_ids(runs);
    const std::span<const StoredRun> all(runs);
    const CompareOptions compare_options = options.comparison.options(all);
    const auto base = all.first(sides.base.size());
    const auto changed = all.subspan(sides.base.size());
    return options.output.print(options.quality_only
                                    ? compare_quality_of_runs(base, changed, compare_options.deciding_figures)
                                    : compare_runs(base, changed, compare_options, find_recorded_noise));
}

}  // namespace

void add_compare_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<CompareCommandOptions>();
    CLI::App* command =
        app.add_subcommand("compare", "Compare stored runs: slower, faster, same or undecided per cell");
    command->add_option("runs", options->folders, "Folders of runs; two need no --")
        ->required()
        ->type_name("BASE... [--] NEW");
    options->comparison.add_to(*command);
    command
        ->add_flag("--quality", options->quality_only,
                   "Compare quality alone, which needs one run a side and no times, on whatever devices")
        ->excludes("--threshold");
    options->output.add_to(*command);
    command->footer(
        "Exit code 0 when nothing is worse, 1 when a cell is slower or its quality worse or mixed (--accept-mixed lets "
        "that pass), 3 when some are undecided or none could be compared, 4 when a cell that was measured in the base "
        "failed now.\n"
        "Example: reliefbench compare --quality results/before results/after\n"
        "Example: reliefbench compare results/before1 results/before2 -- results/after1 results/after2\n");
    command->callback([&chosen, options] { chosen = [options] { return compare(*options); }; });
}

}  // namespace reliefbench
