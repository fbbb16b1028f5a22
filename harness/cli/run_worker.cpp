#include "cli/run_worker.hpp"

#include "cli/progress_printer.hpp"
#include "cli/read_maps.hpp"
#include "cli/results.hpp"
#include "cli/shared_options.hpp"
#include "cli/shell_word.hpp"
#include "cli/terminal.hpp"
#include "core/cache_folder.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/suggest.hpp"
#include "measure/clock.hpp"
#include "measure/device_cells.hpp"
#include "measure/draw_subject.hpp"
#include "measure/run.hpp"
#include "measure/run_pictures.hpp"
#include "measure/run_record.hpp"
#include "measure/run_summary.hpp"
#include "measure/shared_inputs.hpp"
#include "report/run_format.hpp"
#include "store/figures.hpp"
#include "store/resume.hpp"
#include "store/run_folder.hpp"
#include "store/stored_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace reliefbench {

namespace {

void warn_of_constant_maps(const std::vector<HeightMapRecord>& maps) {
    for (const HeightMapRecord& map : maps) {
        if (map.constant) {
            log_warning("height map '{}' is constant: there is no relief in it, and errors say nothing",
                        map.source.name);
        }
    }
}

/// run.json of a run that is resumed: as it was, with a note of when, where and how it was resumed.
Json resumed_record(Json recorded, const Json& now, const std::vector<std::string>& differences) {
    Json note;
    for (const char* part : {"environment", "device", "command_line"})
        note[part] = now.at(part);
    note["differences"] = differences;
    recorded["resumed"].push_back(std::move(note));
    // Cells of both versions stand in it where it is another one that goes on.
    recorded["figures"] = figures_to_json(figures_of_record(recorded, "run.json")->all());
    return recorded;
}

struct OpenedRun {
    std::unique_ptr<RunWriter> writer;
    EarlierWork earlier;
    /// Of a run for advice: what its time cut off goes on.
    std::vector<CellResult> cut_off = {};
};

/// Goes on with the run in the folder, as far as it is the same one.
OpenedRun resume_run(const Json& now, const RunJob& job) {
    const std::filesystem::path& folder = job.folder;
    const Json recorded = read_run_record(folder);
    if (const int format = format_of(JsonView(recorded, folder.string())); format != stored_run_format) {
        fail("{} cannot be resumed: its files have format {}, and this version writes {}; choose another -o",
             folder.string(), format, stored_run_format);
    }
    const std::vector<std::string> differences = resume_differences(recorded, now);
    if (!differences.empty() && job.resume != "force") {
        fail(
            "{} cannot be resumed: {}; choose another -o for a run of its own, or --resume=force, which goes on all "
            "the "
            "same and marks the cells",
            folder.string(), join(differences, "; "));
    }
    for (const std::string& difference : differences)
        log_warning("resuming although {}", difference);
    OpenedRun opened;
    opened.writer =
        std::make_unique<RunWriter>(folder, resumed_record(recorded, now, differences), RunWriter::Continue{});
    for (const std::string& repair : opened.writer->repairs())
        log_warning("{}: {}", folder.string(), repair);
    if (job.chosen && !read_run_summary(folder)) opened.cut_off = opened.writer->take_out_cut_off_cells();
    opened.earlier = read_earlier_work(folder, draw_pass);
    opened.earlier.forced = !differences.empty();
    return opened;
}

OpenedRun open_run(const RunJob& job, const Json& record) {
    if (job.takes_over || !job.resume.empty()) {
        if (holds_run(job.folder)) return resume_run(record, job);
        remove_unstarted_run(job.folder);
    }
    return {std::make_unique<RunWriter>(job.folder, record), {}};
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

/// The finished cells as the folder has them, in the configuration's order; not those that a run which was resumed
/// by force has of another one.
Run read_back(const std::filesystem::path& folder, const std::vector<Cell>& cells) {
    std::unordered_map<std::string_view, std::size_t> order;
    for (const Cell& cell : cells)
        order.emplace(cell.id, order.size());
    Run run = read_run(folder);
    std::erase_if(run.cells, [&order](const CellResult& cell) { return !order.contains(cell.cell); });
    std::sort(run.cells.begin(), run.cells.end(),
              [&order](const CellResult& a, const CellResult& b) { return order.at(a.cell) < order.at(b.cell); });
    return run;
}

/// Where the table is not asked for, standard output is for another program.
void print_outcome(const ChosenOutcome& outcome, const Run& run, const RunJob& job) {
    if (job.chosen) {
        print_results(job.chosen->answer(run, outcome.is_time_over));
        return;
    }
    const RunFormat format = parse_run_format(job.format);
    const TableStyle style{.columns = std::min(table_columns(), TableStyle().columns), .colour = job.colour};
    const std::string table = format_run(run, format, style);
    const std::string summary = format_run_summary(outcome, run.run.at("empty_pass"));
    if (take_standard_output(job.exports)) {
        fmt::print(stderr, "{}{}", table, summary);
    } else if (format == RunFormat::table) {
        print_results(table + summary);
    } else {
        print_results(table);
        fmt::print(stderr, "{}", summary);
    }
}

void say_how_to_go_on(std::size_t finished, const RunJob& job) {
    if (job.chosen) {
        fmt::print(stderr, "reliefbench: interrupted; every sample is kept in {}. The same command goes on\n",
                   job.folder.string());
        return;
    }
    fmt::print(stderr,
               "reliefbench: interrupted with {} of {} finished; every sample is kept. Go on with\n"
               "    reliefbench run {} -o {} --resume\n",
               finished, counted(job.sources.cells.size(), "cell"), shell_word((job.folder / "run.json").string()),
               shell_word(job.folder.string()));
}

/// What stands in run.json before anything is measured.
Json make_record(const RunJob& job, const gpu::Device& device) {
    const std::vector<HeightMapRecord> maps = read_maps(job.sources.cells);
    warn_of_constant_maps(maps);
    Json record = make_run_record(
        {job.sources.configuration, job.sources.library, job.sources.cells, maps, device, job.sharing.share});
    record["command_line"] = job.command_line;
    record["filters"] = job.sources.filters;
    if (job.chosen) record["question"] = job.chosen->question;
    if (job.shard) record["shard"] = {{"index", job.shard->index}, {"count", job.shard->count}};
    record["technique_directories"] = job.sources.technique_directories;
    return record;
}

/// Recorded by what was measured before, of the cells that are finished.
std::vector<CellResult> finished_cells(const std::filesystem::path& folder, const EarlierWork& earlier) {
    if (earlier.finished.empty()) return {};
    return read_run(folder).cells;
}

ChosenOutcome measure(const RunJob& job, const gpu::Device& device, OpenedRun& opened, WorkerStatus& status) {
    RunWriter& writer = *opened.writer;
    const Configuration& configuration = job.sources.configuration;
    if (configuration.images) write_legends(writer);
    MapMaking maps{.cache = cache_folder(),
                   .failed = crashed_preparations(opened.earlier.crashed_preparations),
                   .on_maps = [&status](const std::string& key) { status.begin_maps(key); },
                   .timed = !job.chosen};
    DeviceCells source(device, job.sources.library, configuration, job.sources.cells, writer, std::move(maps));
    ProgressPrinter printer;
    const auto on_progress = [&printer](const Progress& progress) { printer(progress); };
    ChosenOptions options;
    options.finished = job.chosen ? finished_cells(writer.folder(), opened.earlier) : std::vector<CellResult>();
    options.cut_off = std::move(opened.cut_off);
    options.earlier = std::move(opened.earlier);
    options.is_interrupted = [&status] { return status.is_interrupted(); };
    options.on_cell = [&status](const std::string& cell) { status.begin_cell(cell); };
    if (!job.chosen)
        return {run_cells(source, configuration, job.sources.cells, writer, on_progress, steady_clock(), options)};
    options.deadline_s = steady_clock().seconds() + job.chosen->time_s - status.measuring_s();
    return run_chosen_cells(source, configuration, job.sources.cells, writer, *job.chosen->chooser, on_progress,
                            steady_clock(), options);
}

gpu::DeviceOptions watched(gpu::DeviceOptions options, WorkerStatus& status) {
    options.on_submit = [&status](int passes) { status.begin_passes(passes); };
    options.on_end = [&status] { status.end_passes(); };
    return options;
}

}  // namespace

ExitCode work_on_run(const RunJob& job, WorkerStatus& status) {
    const double start_s = steady_clock().seconds();
    const gpu::Device device(watched(job.device, status));
    const std::optional<DeviceLock> lock =
        job.sharing.lock(device.info(), [&status] { return status.is_interrupted(); });
    if (lock && !lock->is_held()) {
        status.end(WorkerStatus::Ending::interrupted);
        return ExitCode::done;
    }
    OpenedRun opened = open_run(job, make_record(job, device));
    RunWriter& writer = *opened.writer;
    fmt::print(stderr, "{} on {}, results in {}\n", counted(job.sources.cells.size(), "cell"), device.info().name,
               writer.folder().string());
    if (!opened.earlier.finished.empty()) {
        fmt::print(stderr, "finished already: {}\n", counted(opened.earlier.finished.size(), "cell"));
    }

    ChosenOutcome outcome = measure(job, device, opened, status);
    outcome.split.total_s = steady_clock().seconds() - start_s;
    if (outcome.device_lost && outcome.ended_early) {
        fmt::print(stderr, "reliefbench: {} was lost; another worker goes on\n", device.info().name);
        status.end(WorkerStatus::Ending::device_lost);
        return ExitCode::done;
    }
    const Run run = read_back(writer.folder(), job.sources.cells);
    outcome.tally = {};
    for (const CellResult& cell : run.cells)
        outcome.tally.add(cell);
    print_outcome(outcome, run, job);
    if (outcome.ended_early) {
        say_how_to_go_on(run.cells.size(), job);
        status.end(WorkerStatus::Ending::interrupted);
        return ExitCode::done;
    }
    if (run.cells.size() == job.sources.cells.size())
        writer.write_summary(make_run_summary(outcome, run.run.at("empty_pass")));
    write_exports(writer.folder(), job.exports);
    status.end(WorkerStatus::Ending::finished);
    // Few samples may well be too few for some technique: that is part of an answer.
    const ExitCode failures = job.chosen ? ExitCode::done : report_failures(run.cells);
    return worse_of(failures, check_validation(device));
}

}  // namespace reliefbench
