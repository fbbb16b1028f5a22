#include "cli/colour_choice.hpp"
#include "cli/command.hpp"
#include "cli/export_target.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress_printer.hpp"
#include "cli/results.hpp"
#include "cli/run_sources.hpp"
#include "cli/shard_choice.hpp"
#include "cli/shared_options.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "measure/clock.hpp"
#include "measure/draw_subject.hpp"
#include "measure/run.hpp"
#include "measure/run_record.hpp"
#include "measure/run_summary.hpp"
#include "measure/shared_inputs.hpp"
#include "report/run_format.hpp"
#include "store/resume.hpp"
#include "store/run_folder.hpp"
#include "technique/map_cache.hpp"

#include <CLI/CLI.hpp>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
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
    std::vector<std::string> axes;
    std::vector<std::string> filters;
    std::vector<std::string> exports;
    std::string format = run_format_names().front();
    std::string shard;
    bool dry_run = false;
    ColourChoice colour;
    TechniqueOptions library;
    DeviceChoice device;
    PreparationOptions preparation;
    std::vector<std::string> command_line;
};

ExitCode print_plan(const std::vector<Cell>& cells) {
    const std::vector<Block> blocks = make_blocks(cells);
    std::size_t measured = 0;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        fmt::print("block {} of {}:\n", block + 1, blocks.size());
        for (std::size_t index : blocks[block].cells) {
            fmt::print("  {}\n", cells[index].id);
        }
        measured += blocks[block].cells.size();
    }
    if (measured < cells.size()) fmt::print("skipped:\n");
    for (const Cell& cell : cells) {
        if (!cell.skip_reason.empty()) fmt::print("  {}: {}\n", cell.id, cell.skip_reason);
    }
    fmt::print("{} cells in {} blocks, {} skipped\n", measured, blocks.size(), cells.size() - measured);
    return ExitCode::done;
}

std::filesystem::path output_folder(const RunOptions& options, const Configuration& configuration) {
    if (!options.output.empty()) return options.output;
    const std::tm now = fmt::localtime(std::time(nullptr));
    return std::filesystem::path("results") / fmt::format("{}-{:%Y%m%d-%H%M%S}", configuration.name, now);
}

void warn_of_constant_maps(const std::vector<HeightMapRecord>& maps) {
    for (const HeightMapRecord& map : maps) {
        if (map.constant) {
            log_warning("height map '{}' is constant: there is no relief in it, and errors say nothing",
                        map.source.name);
        }
    }
}

/// run.json of a run that is gone on with: as it was, with a note of when, where and how it was gone on with.
Json resumed_record(Json recorded, const Json& now, const std::vector<std::string>& differences) {
    Json note;
    for (const char* part : {"environment", "device", "command_line"})
        note[part] = now.at(part);
    note["differences"] = differences;
    recorded["resumed"].push_back(std::move(note));
    return recorded;
}

struct OpenedRun {
    std::unique_ptr<RunWriter> writer;
    EarlierWork earlier;
};

/// Goes on with the run in the folder, as far as it is the same one.
OpenedRun resume_run(const std::filesystem::path& folder, const Json& now, bool force) {
    const Json recorded = read_run_record(folder);
    const std::vector<std::string> differences = resume_differences(recorded, now);
    if (!differences.empty() && !force) {
        fail("{} cannot be resumed: {}; --resume=force goes on all the same and marks the cells", folder.string(),
             join(differences, "; "));
    }
    for (const std::string& difference : differences)
        log_warning("resuming although {}", difference);
    OpenedRun opened;
    opened.writer =
        std::make_unique<RunWriter>(folder, resumed_record(recorded, now, differences), RunWriter::Continue{});
    for (const std::string& repair : opened.writer->repairs())
        log_warning("{}: {}", folder.string(), repair);
    opened.earlier = read_earlier_work(folder, draw_pass);
    opened.earlier.forced = !differences.empty();
    return opened;
}

OpenedRun open_run(const std::filesystem::path& folder, const Json& record, const std::string& resume) {
    if (!resume.empty()) {
        if (holds_run(folder)) return resume_run(folder, record, resume == "force");
        remove_unstarted_run(folder);
    }
    return {std::make_unique<RunWriter>(folder, record), {}};
}

ExitCode report_failures(const std::vector<CellResult>& cells) {
    std::size_t failures = 0;
    for (const CellResult& cell : cells) {
        if (cell.status == CellStatus::failed) {
            ++failures;
            fmt::print(stderr, "reliefbench: cell failed: {}: {}\n", cell.cell, cell.reason);
        }
    }
    return failures > 0 ? ExitCode::cells_failed : ExitCode::done;
}

/// As a shell takes it.
std::string quoted_word(const std::filesystem::path& path) {
    const std::string text = path.string();
    if (text.find_first_of(" '\"\\$`*?;&|<>()") == std::string::npos) return text;
    std::string quoted = "'";
    for (const char character : text) {
        quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
    }
    return quoted + "'";
}

/// Where the table is not asked for, standard output is for another program.
void print_outcome(const RunOutcome& outcome, const Json& record, const RunOptions& options) {
    const RunFormat format = parse_run_format(options.format);
    const TableStyle style{.columns = std::min(table_columns(), TableStyle().columns),
                           .colour = options.colour.is_wanted()};
    print_results(format_run({record, outcome.cells}, format, style));
    const std::string summary = format_run_summary(outcome, record.at("empty_pass"));
    if (format == RunFormat::table) {
        print_results(summary);
    } else {
        fmt::print(stderr, "{}", summary);
    }
}

ExitCode run(const RunOptions& options) {
    const double start_s = steady_clock().seconds();
    parse_run_format(options.format);
    const std::vector<ExportTarget> exports = parse_export_targets(options.exports);
    RunSources sources = read_run_sources(options.configuration, options.axes, options.filters, options.library);
    const std::optional<Shard> shard = chosen_shard(options.shard, read_json_file(options.configuration));
    if (shard) sources.cells = cells_of_shard(sources.cells, *shard);
    if (options.preparation.limit_s) set_preparation_limit(sources.configuration, *options.preparation.limit_s);
    if (options.dry_run) return print_plan(sources.cells);

    const std::vector<HeightMapRecord> maps = inspect_height_maps(sources.cells);
    warn_of_constant_maps(maps);
    const gpu::Device device(options.device.options);
    Json record = make_run_record({sources.configuration, sources.library, sources.cells, maps, device});
    record["command_line"] = options.command_line;
    record["filters"] = sources.filters;
    if (shard) record["shard"] = {{"index", shard->index}, {"count", shard->count}};
    record["technique_directories"] = sources.technique_directories;
    if (!options.resume.empty() && options.output.empty()) fail("--resume needs -o, the folder of the run");
    OpenedRun opened = open_run(output_folder(options, sources.configuration), record, options.resume);
    RunWriter& writer = *opened.writer;
    fmt::print(stderr, "{} cells on {}, results in {}\n", sources.cells.size(), device.info().name,
               writer.folder().string());
    if (!opened.earlier.finished.empty()) {
        fmt::print(stderr, "{} of them are finished already\n", opened.earlier.finished.size());
    }

    const InterruptWatch watch("\nreliefbench: interrupted; finishing the visit (interrupt again to end at once)\n");
    RunOutcome outcome;
    {
        ProgressPrinter printer;
        outcome = run_cells(device, sources.library, sources.configuration, sources.cells, writer,
                            [&printer](const Progress& progress) { printer(progress); }, steady_clock(),
                            {.in_flight = {},
                             .map_cache = map_cache_folder(),
                             .earlier = std::move(opened.earlier),
                             .is_interrupted = [&watch] { return watch.signal() != 0; }});
    }
    outcome.split.total_s = steady_clock().seconds() - start_s;
    const Json& empty_pass = record.at("empty_pass");
    print_outcome(outcome, record, options);
    if (outcome.interrupted) {
        fmt::print(stderr,
                   "reliefbench: interrupted with {} of {} cells finished; every sample is kept. Go on with\n"
                   "    reliefbench run {} -o {} --resume\n",
                   outcome.cells.size(), sources.cells.size(), quoted_word(writer.folder() / "run.json"),
                   quoted_word(writer.folder()));
        throw Interrupted{watch.signal()};
    }
    writer.write_summary(make_run_summary(outcome, empty_pass));
    write_exports(writer.folder(), exports);
    return graver(report_failures(outcome.cells), check_validation(device));
}

}  // namespace

void add_run_command(CLI::App& app, ChosenCommand& chosen, const std::vector<std::string>& command_line) {
    const auto options = std::make_shared<RunOptions>();
    options->command_line = command_line;
    CLI::App* command = app.add_subcommand("run", "Measure every cell of a configuration");
    command->add_option("configuration", options->configuration, "A configuration, or the run.json of an earlier run")
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
        ->type_name("")
        ->check(CLI::IsMember({"plain", "force"}));
    add_repeated_option(*command, "-a,--axis", options->axes,
                        "Values of an axis or parameter in place of the configuration's: name=v1,v2 or "
                        "name=[start:stop:step] (may be repeated)")
        ->type_name("NAME=VALUES");
    add_repeated_option(*command, "--filter", options->filters,
                        "Keep only cells that fulfil this: technique=pom,qdm, view_angle>=60 (may be repeated; all "
                        "must hold)")
        ->type_name("EXPR");
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
    command->add_flag("--dry-run", options->dry_run, "Print blocks and cells; measure and write nothing");
    options->library.add_to(*command);
    options->device.add_to(*command);
    options->preparation.add_to(*command);
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
