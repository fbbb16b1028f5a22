#include "cli/command.hpp"
#include "cli/output_file.hpp"
#include "cli/results.hpp"
#include "cli/run_sources.hpp"
#include "cli/terminal.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "report/run_format.hpp"
#include "store/merge.hpp"
#include "sweep/shard.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

namespace reliefbench {

namespace {

struct MergeOptions {
    std::string output;
    std::vector<std::string> folders;
    bool partial = false;
};

/// With the techniques that this machine has: where they are not those that were measured, nothing is known.
std::vector<PlannedCell> planned_cells(const std::vector<NamedRun>& shards) {
    try {
        const std::string record = (std::filesystem::path(shards.front().name) / "run.json").string();
        const RunSources sources = read_run_sources(read_configuration_text(record), {}, {});
        for (const NamedRun& run : shards) {
            for (const auto& [id, hash] : run.run.run.at("techniques").items()) {
                if (sources.library.get(id).hash != hash) fail("the technique '{}' has changed since", id);
            }
        }
        const auto count = shards.front().run.run.at("shard").at("count").get<std::size_t>();
        const std::vector<std::size_t> shard_of_cell = shards_of_cells(sources.cells, count);
        std::vector<PlannedCell> planned;
        for (std::size_t cell = 0; cell < shard_of_cell.size(); ++cell)
            planned.push_back({sources.cells[cell].id, shard_of_cell[cell]});
        return planned;
    } catch (const Error& error) {
        log_warning("whether cells are missing cannot be told here: {}", error.what());
    } catch (const Json::exception&) {
        // What the record lacks merge_runs tells.
    }
    return {};
}

/// Not longer than anyone reads.
std::string missing_text(std::vector<std::string> missing) {
    constexpr std::size_t max_listed = 10;
    const std::size_t count = missing.size();
    if (count > max_listed) {
        missing.resize(max_listed);
        missing.push_back(fmt::format("and {} more", count - max_listed));
    }
    return join(missing);
}

ExitCode merge(const MergeOptions& options) {
    refuse_standard_output(options.output, "a run is a folder; its table goes to standard output anyway");
    std::vector<NamedRun> shards;
    for (const std::string& folder : options.folders)
        shards.push_back({folder, read_run(folder)});
    const std::vector<PlannedCell> planned = planned_cells(shards);
    const MergedRun merged = merge_runs(std::move(shards), planned);
    if (!merged.missing.empty()) {
        const std::string missing = missing_text(merged.missing);
        if (!options.partial) fail("missing: {}; --partial merges what there is", missing);
        log_warning("missing: {}", missing);
    }
    RunWriter writer(options.output, merged.run.run);
    for (const std::string& folder : options.folders)
        writer.append_recorded(folder);
    fmt::print(stderr, "{} of {} in {}\n", counted(merged.run.cells.size(), "cell"),
               counted(options.folders.size(), "shard"), options.output);
    print_results(
        format_run(merged.run, RunFormat::table, {.columns = std::min(table_columns(), TableStyle().columns)}));
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
    command->add_flag("--partial", options->partial, "Merge although shards or cells are missing");
    command->footer(
        "Shards must have the same configuration, sources, height maps, device and driver: times of different devices\n"
        "never meet in one statistic. A cell or a shard that stands in two of them, or in none, is an error (exit code "
        "2).\n"
        "Example: reliefbench merge results/whole results/part-*\n");
    command->callback([&chosen, options] { chosen = [options] { return merge(*options); }; });
}

}  // namespace reliefbench
