#include "cli/command.hpp"
#include "cli/results.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "report/table.hpp"
#include "store/merge.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace reliefbench {

namespace {

struct MergeOptions {
    std::string output;
    std::vector<std::string> folders;
    bool partial = false;
};

ExitCode merge(const MergeOptions& options) {
    std::vector<NamedRun> shards;
    for (const std::string& folder : options.folders)
        shards.push_back({folder, read_run(folder)});
    const MergedRun merged = merge_runs(shards);
    if (!merged.missing.empty()) {
        const std::string missing = join(merged.missing);
        if (!options.partial) fail("{} missing: {}; --partial merges what there is", merged.missing.size(), missing);
        log_warning("missing: {}", missing);
    }
    RunWriter writer(options.output, merged.run.run);
    for (const CellResult& cell : merged.run.cells)
        writer.append_cell(cell);
    for (const std::string& folder : options.folders)
        writer.append_recorded(folder);
    fmt::print(stderr, "{} cells of {} shards in {}\n", merged.run.cells.size(), shards.size(), options.output);
    print_results(format_table(merged.run.cells, {.columns = std::min(table_columns(), TableStyle().columns)}));
    return ExitCode::done;
}

}  // namespace

void add_merge_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<MergeOptions>();
    CLI::App* command = app.add_subcommand("merge", "Put the shards of one run together (`run --shard I/N`)");
    command->add_option("output", options->output, "Folder for the merged run; it must not hold a run yet")
        ->required()
        ->type_name("OUT");
    command->add_option("runs", options->folders, "Folders of the shards")->required()->type_name("RUN");
    command->add_flag("--partial", options->partial, "Merge although shards are missing");
    command->footer(
        "Shards must have the same configuration, sources, height maps, device and driver: times of different devices\n"
        "never meet in one statistic. A cell or a shard that stands in two of them is an error (exit code 2).\n"
        "Example: reliefbench merge results/whole results/part-*\n");
    command->callback([&chosen, options] { chosen = [options] { return merge(*options); }; });
}

}  // namespace reliefbench
