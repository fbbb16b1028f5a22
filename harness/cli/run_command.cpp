#include "cli/colour_choice.hpp"
#include "cli/command.hpp"
#include "cli/configuration_text.hpp"
#include "cli/device_lock.hpp"
#include "cli/duration.hpp"
#include "cli/export_target.hpp"
#include "cli/output_file.hpp"
#include "cli/results.hpp"
#include "cli/run_worker.hpp"
#include "cli/shard_choice.hpp"
#include "cli/shared_options.hpp"
#include "cli/supervisor.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "measure/shared_inputs.hpp"
#include "report/run_format.hpp"
#include "store/run_folder.hpp"
#include "technique/map_needs.hpp"

#include <CLI/CLI.hpp>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>

namespace reliefbench {

namespace {

struct RunOptions {
    std::string configuration;
    std::string output;
    /// Empty, "plain" or "force".
    std::string resume;
    CellChoice cells;
    SamplingChoice sampling;
    std::vector<std::string> exports;
    std::string format = run_format_names().front();
    std::string shard;
    bool dry_run = false;
    std::string pass_timeout = "10s";
    ColourChoice colour;
    TechniqueOptions library;
    DeviceChoice device;
    DeviceSharing sharing;
    PreparationOptions preparation;
    std::vector<std::string> command_line;
};

ExitCode print_plan(const std::vector<Cell>& cells) {
    const std::vector<Block> blocks = make_blocks(cells);
    std::size_t measured = 0;
    std::string plan;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        plan += fmt::format("block {} of {}:\n", block + 1, blocks.size());
        for (std::size_t index : blocks[block].cells) {
            plan += fmt::format("  {}\n", cells[index].id);
        }
        measured += blocks[block].cells.size();
    }
    if (measured < cells.size()) plan += "skipped:\n";
    for (const Cell& cell : cells) {
        if (!cell.skip_reason.empty()) plan += fmt::format("  {}: {}\n", cell.id, cell.skip_reason);
    }
    print_results(plan + fmt::format("{} in {}, {} skipped\n", counted(measured, "cell"),
                                     counted(blocks.size(), "block"), cells.size() - measured));
    return ExitCode::done;
}

/// The name of a configuration, whoever wrote it, as the beginning of a folder's: it leads nowhere else, shows in
/// listings, and has room for what follows it.
std::string folder_name(const std::string& name) {
    constexpr std::size_t longest = 180;
    std::size_t end = std::min(longest, name.size());
    // Not in the middle of a character of UTF-8.
    while (end > 0 && end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U)
        --end;
    std::string folder = name.substr(0, end);
    for (char& character : folder) {
        if (character == '/' || std::iscntrl(static_cast<unsigned char>(character)) != 0) character = '_';
    }
    if (folder.starts_with('.')) folder.front() = '_';
    return folder.empty() ? "run" : folder;
}

std::filesystem::path output_folder(const RunOptions& options, const Configuration& configuration) {
    if (!options.output.empty()) return options.output;
    const std::tm now = fmt::localtime(std::time(nullptr));
    return std::filesystem::path("results") / fmt::format("{}-{:%Y%m%d-%H%M%S}", folder_name(configuration.name), now);
}

RunJob make_job(const RunOptions& options, const ConfigurationText& configuration) {
    parse_run_format(options.format);
    RunJob job{.sources = read_run_sources(configuration, options.cells, options.library),
               .resume = options.resume,
               .format = options.format,
               .colour = options.colour.is_wanted(),
               .exports = parse_export_targets(options.exports),
               .device = options.device.options,
               .sharing = options.sharing,
               .command_line = options.command_line};
    if (take_standard_output(job.exports) && options.format != run_format_names().front()) {
        fail("--export to standard output and --format {} exclude each other; give the export a file", options.format);
    }
    set_sampling(job.sources.configuration, options.sampling.settings);
    job.shard = chosen_shard(options.shard, job.sources.shard);
    if (job.shard) job.sources.cells = take_shard(job.sources.cells, *job.shard);
    if (options.preparation.limit_s) set_preparation_limit(job.sources.configuration, *options.preparation.limit_s);
    return job;
}

/// Skips the cells whose height map is not what their technique needs.
void skip_unfit_maps(RunSources& sources) {
    for (Cell& cell : sources.cells) {
        if (!cell.skip_reason.empty()) continue;
        const Manifest& manifest = sources.library.get(cell.technique).manifest;
        if (manifest.map_needs.empty()) continue;
        cell.skip_reason = unmet_map_need(manifest, height_map_size(cell.view.height_map), cell.view.view.relief);
    }
}

/// Refuses what a run would refuse before it asks for the device.
ExitCode plan(const RunOptions& options, const ConfigurationText& configuration) {
    RunJob job = make_job(options, configuration);
    if (job.resume.empty() && !options.output.empty()) refuse_second_run(options.output);
    check_input_files(job.sources.cells);
    skip_unfit_maps(job.sources);
    return print_plan(job.sources.cells);
}

ExitCode run_as_worker(const RunOptions& options, const ConfigurationText& configuration, WorkerStatus& status) {
    RunJob job = make_job(options, configuration);
    job.takes_over = !status.folder().empty();
    job.folder = job.takes_over ? status.folder() : output_folder(options, job.sources.configuration);
    if (job.resume.empty() && !job.takes_over) refuse_second_run(job.folder);
    status.set_folder(job.folder);
    return work_on_run(job, status);
}

ExitCode run(const RunOptions& options) {
    const double pass_timeout_s = parse_duration(options.pass_timeout, "--pass-timeout");
    refuse_standard_output(options.output, "a run is a folder; its table goes to standard output anyway");
    if (!options.resume.empty() && options.output.empty()) fail("--resume needs -o, the folder of the run");
    const std::unique_ptr<WorkerStatus> status = take_worker_status();
    const std::optional<ConfigurationText> handed = take_handed_configuration(options.configuration);
    const ConfigurationText configuration = handed ? *handed : read_configuration_text(options.configuration);
    if (options.dry_run) return plan(options, configuration);
    if (status) return run_as_worker(options, configuration, *status);
    const HandedConfiguration handing(configuration);
    return supervise({options.command_line, pass_timeout_s, options.pass_timeout, handing});
}

}  // namespace

void add_run_command(CLI::App& app, ChosenCommand& chosen, const std::vector<std::string>& command_line) {
    const auto options = std::make_shared<RunOptions>();
    options->command_line = command_line;
    CLI::App* command = app.add_subcommand("run", "Measure every cell of a configuration");
    command
        ->add_option("configuration", options->configuration,
                     "A configuration, or the run.json of an earlier run, - for standard input")
        ->required()
        ->type_name("CONFIG");
    command
        ->add_option("-o,--output", options->output,
                     "Folder for the results; it must not hold a run yet; default: results/<name>-<time>")
        ->type_name("DIR");
    command
        ->add_flag(
            "--resume{plain}", options->resume,
            "Go on with the run in -o where it was interrupted, or start it where there is none; refused when its "
            "configuration, maps, shaders or device are not the same, unless --resume=force, which marks the cells")
        ->option_text("[=force]")
        ->check([](const std::string& mode) {
            return mode == "plain" || mode == "force" ? "" : fmt::format("expected force or nothing, found '{}'", mode);
        });
    options->cells.add_to(*command);
    options->sampling.add_to(*command);
    add_repeated_option(
        *command, "--export", options->exports,
        "Write the finished run for other tools, too: " + join(export_format_names()) + " (may be repeated)")
        ->type_name("FORMAT=FILE");
    command
        ->add_option("--format", options->format,
                     "What goes to standard output: the table, or for scripts markdown, csv (one row per cell) or json "
                     "(an array of the cells); default: table")
        ->type_name(join(run_format_names(), "|"));
    options->colour.add_to(*command);
    command
        ->add_option(
            "--shard", options->shard,
            "Measure one of N parts only, on this machine: I/N, I from 1; `merge` puts them together; default: "
            "SLURM_ARRAY_TASK_ID of an array, GTEST_SHARD_INDEX, else all")
        ->type_name("I/N");
    command->add_flag(
        "--dry-run", options->dry_run,
        "Print blocks and cells; measure and write nothing. Height map and albedo files are loaded, so that what "
        "a run would refuse is refused here; the device is not asked: what it cannot hold, and "
        "preparations beyond their limit, are skipped when the run comes to them");
    options->library.add_to(*command);
    options->device.add_to(*command);
    options->sharing.add_to(*command);
    options->preparation.add_to(*command);
    command
        ->add_option("--pass-timeout", options->pass_timeout,
                     "Give up a cell when one of its passes on the device takes longer: 0.5s, 10s, 2m; default: 10s")
        ->type_name("DURATION");
    command->footer(
        "The table goes to standard output, progress to standard error. Exit code 4 when some cells failed.\n"
        "Ctrl-C (or SIGTERM) finishes the visit at hand, shows the cells that are finished and says how to go on; the\n"
        "second one ends at once. Every sample is kept. The program then ends by that signal: a shell reports 130.\n"
        "Example: reliefbench run configs/quick.json -a view_angle=0,60 --filter technique=pom,qdm -o results/mine\n"
        "Example: reliefbench run configs/quick.json -o results/mine --resume\n"
        "Example: reliefbench run configs/smoke.json --format csv > cells.csv\n");
    command->callback([&chosen, options] { chosen = [options] { return run(*options); }; });
}

}  // namespace reliefbench
