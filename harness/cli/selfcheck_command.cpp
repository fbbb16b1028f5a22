#include "cli/command.hpp"
#include "cli/device_lock.hpp"
#include "cli/duration.hpp"
#include "cli/progress_printer.hpp"
#include "cli/read_maps.hpp"
#include "cli/results.hpp"
#include "cli/run_sources.hpp"
#include "cli/shared_options.hpp"
#include "cli/variant_comparison.hpp"
#include "compare/between_runs.hpp"
#include "compare/run_noise.hpp"
#include "compare/run_side.hpp"
#include "core/cache_folder.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/log.hpp"
#include "core/process.hpp"
#include "core/scratch_folder.hpp"
#include "core/suggest.hpp"
#include "measure/draw_subject.hpp"
#include "measure/run_record.hpp"
#include "measure/shared_inputs.hpp"
#include "measure/variants.hpp"
#include "report/comparison_words.hpp"
#include "report/text_layout.hpp"
#include "store/device_share.hpp"
#include "store/noise_record.hpp"
#include "store/run_folder.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace reliefbench {

namespace {

/// What `ab` and `compare` take unless told otherwise.
constexpr double threshold_within = 0.01;
constexpr double threshold_between = 0.02;
/// Of the budget, for what is seen within one process.
constexpr double share_within = 0.3;
/// Of a process's time, for sampling: the rest compiles, traces truths and warms up.
constexpr double share_sampling = 0.6;
/// Fewer say next to nothing about how far runs lie apart.
constexpr int min_processes = 3;

struct SelfcheckOptions {
    std::string configuration;
    int processes = 6;
    std::string budget = "5m";
    CellChoice cells;
    SamplingChoice sampling;
    TechniqueOptions library;
    DeviceChoice device;
    DeviceSharing sharing;
};

/// What each process runs: the same cells, in a time that lets all processes end within the budget.
std::filesystem::path write_run_configuration(const SelfcheckOptions& options, const RunSources& sources,
                                              double budget_s, const std::filesystem::path& folder) {
    Json configuration = sources.configuration.expanded;
    const auto cells = static_cast<double>(sources.cells.size());
    const double share_s = share_sampling * budget_s / options.processes / cells;
    configuration["sampling"]["budget_s"] = std::min(sources.configuration.sampling.budget_s, share_s);
    const std::filesystem::path path = folder / "configuration.json";
    write_text_file(path, configuration.dump());
    return path;
}

/// The command line of a process that runs the configuration into `folder`.
std::vector<std::string> run_command_line(const SelfcheckOptions& options, const std::string& configuration,
                                          const std::string& folder) {
    std::vector<std::string> words{"/proc/self/exe", "run", configuration, "-o", folder};
    const auto add = [&](const std::string& name, const std::vector<std::string>& values) {
        for (const std::string& value : values) {
            words.push_back(name);
            words.push_back(value);
        }
    };
    add("--filter", options.cells.filters);
    add("--techniques", options.library.directories);
    if (!options.device.options.choice.empty()) add("--device", {options.device.options.choice});
    if (options.sharing.share) words.emplace_back("--share-device");
    return words;
}

/// One more process.
Run run_once(const SelfcheckOptions& options, const std::filesystem::path& configuration,
             const std::filesystem::path& folder) {
    const FinishedProcess finished = run_process(run_command_line(options, configuration.string(), folder.string()));
    const bool some_failed = finished.exit_code == static_cast<int>(ExitCode::cells_failed);
    if (finished.exit_code != 0 && !some_failed) {
        fail("a process of the self-check ended with exit code {}: {}", finished.exit_code, finished.errors);
    }
    return read_run(folder);
}

void collect_medians(const Run& run, std::vector<NoiseRecord::Cell>& cells) {
    for (const CellResult& result : run.cells) {
        const auto draw = result.time.find(draw_pass);
        if (result.status != CellStatus::ok || draw == result.time.end() || !(draw->second.median_ms > 0)) continue;
        const auto same_cell = [&](const NoiseRecord::Cell& cell) { return cell.cell == result.cell; };
        auto found = std::find_if(cells.begin(), cells.end(), same_cell);
        if (found == cells.end()) found = cells.insert(cells.end(), NoiseRecord::Cell{result.cell, {}, 0, 0});
        found->log_median_ms.push_back(std::log(figure_of(draw->second, Figure::lower_quartile)));
    }
}

/// As many processes as asked for, or as fit into the budget.
int run_processes(const SelfcheckOptions& options, const RunSources& sources, double budget_s,
                  std::vector<NoiseRecord::Cell>& cells) {
    const Clock& clock = steady_clock();
    const double begin_s = clock.seconds();
    const ScratchFolder scratch;
    const std::filesystem::path configuration = write_run_configuration(options, sources, budget_s, scratch.path());
    for (int done = 0; done < options.processes; ++done) {
        const double spent_s = clock.seconds() - begin_s;
        if (done >= min_processes && spent_s * (done + 1) / done > budget_s) return done;
        fmt::print(stderr, "process {} of {}\n", done + 1, options.processes);
        const std::filesystem::path folder = scratch.path() / fmt::format("run{}", done);
        collect_medians(run_once(options, configuration, folder), cells);
        std::filesystem::remove_all(folder);
    }
    return options.processes;
}

/// Above this it is no use to anybody by how much.
std::string visible_text(double fraction) {
    constexpr double most = 10;
    return fraction > most ? fmt::format("over {:.0f} %", 100 * most) : percent_text(fraction);
}

/// The smallest change that shows between `runs` identical runs a side which scatter by `noise`.
double visible_between_runs(int runs, const RunNoise& noise) {
    // Evenly spread values whose standard deviation is that of the noise.
    std::vector<double> milliseconds;
    for (int run = 0; run < runs; ++run) {
        const double spread = runs == 1 ? 0 : noise.log_sd * std::sqrt(12.0 / (runs * (runs + 1.0)));
        milliseconds.push_back(std::exp((run - (runs - 1) / 2.0) * spread));
    }
    return estimate_between_runs(milliseconds, milliseconds, noise, threshold_between).visible;
}

double standard_deviation(const std::vector<double>& values) {
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double squares = 0;
    for (const double value : values) {
        squares += (value - mean) * (value - mean);
    }
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

std::string describe_between_runs(const NoiseRecord& record, int processes) {
    std::vector<double> deviations;
    for (const NoiseRecord::Cell& cell : record.cells) {
        if (cell.log_median_ms.size() >= 2) deviations.push_back(standard_deviation(cell.log_median_ms));
    }
    std::string text =
        fmt::format("between processes ({} of them): medians of identical runs scatter by {} (standard deviation)\n",
                    processes, percent_text(std::expm1(record.between_runs.log_sd)));
    const auto with_deviation = [&](double log_sd) {
        RunNoise noise = record.between_runs;
        noise.log_sd = log_sd;
        return noise;
    };
    const RunNoise middle = with_deviation(median(deviations));
    const RunNoise worst = with_deviation(*std::max_element(deviations.begin(), deviations.end()));
    text +=
        fmt::format("  smallest change that `compare` sees at a threshold of {}:\n", percent_text(threshold_between));
    text += "    runs a side   all cells  median cell   worst cell\n";
    for (const int runs : {1, 3, 5, 10}) {
        text += fmt::format(
            "    {:11} {:>11} {:>12} {:>12}\n", runs, visible_text(visible_between_runs(runs, record.between_runs)),
            visible_text(visible_between_runs(runs, middle)), visible_text(visible_between_runs(runs, worst)));
    }
    return text;
}

std::string describe_within_process(const Comparison& comparison, double seconds) {
    std::vector<double> visible;
    std::vector<double> rounds;
    for (const CellComparison& cell : comparison.cells) {
        visible.push_back(cell.time.visible);
        rounds.push_back(static_cast<double>(cell.time.units));
    }
    if (visible.empty()) return "within one process: no cell could be measured\n";
    return fmt::format(
        "within one process ({:.0f} s for {}, {:.0f} rounds): smallest change that `ab` sees at a threshold of {}: {} "
        "in the median cell, {} in the worst\n",
        seconds, counted(visible.size(), "cell"), median(rounds), percent_text(threshold_within),
        visible_text(median(visible)), visible_text(*std::max_element(visible.begin(), visible.end())));
}

/// Identical code that was called slower or faster: the method does not hold on this machine.
bool report_false_verdicts(const Comparison& comparison) {
    bool any = false;
    for (const CellComparison& cell : comparison.cells) {
        if (cell.verdict != Verdict::slower && cell.verdict != Verdict::faster) continue;
        any = true;
        log_error("FALSE VERDICT: identical code was called {}: {}: {}", to_string(cell.verdict), cell.cell,
                  cell.reason);
    }
    return any;
}

void keep_visible(const Comparison& comparison, std::vector<NoiseRecord::Cell>& cells) {
    for (NoiseRecord::Cell& cell : cells) {
        for (const CellComparison& compared : comparison.cells) {
            if (compared.cell != cell.cell) continue;
            cell.visible_paired = compared.time.visible;
            cell.rounds = compared.time.units;
        }
    }
}

ExitCode selfcheck(SelfcheckOptions options) {
    const double budget_s = parse_duration(options.budget, "--budget");
    if (options.processes < min_processes) {
        fail("--processes: expected at least {}, found {}", min_processes, options.processes);
    }
    if (options.configuration.empty()) options.configuration = (configuration_root() / "quick.json").string();
    RunSources sources =
        read_run_sources(read_configuration_text(options.configuration), options.cells, options.library);
    set_sampling(sources.configuration, options.sampling.settings);
    // Before anything is measured, so that a machine without a place to keep it is told at once.
    const std::filesystem::path folder = state_folder();
    NoiseRecord record;
    record.configuration = sources.configuration.name;
    Comparison comparison;
    VariantSettings settings;
    settings.cache = cache_folder();
    settings.budget_s = share_within * budget_s;
    settings.seed = sources.configuration.seed;
    ExitCode code = ExitCode::done;
    {
        const gpu::Device device(options.device.options);
        const std::optional<DeviceLock> lock = options.sharing.lock(device.info());
        const std::vector<HeightMapRecord> maps = read_maps(sources.cells);
        const Json run = make_run_record(
            {sources.configuration, sources.library, sources.cells, maps, device, options.sharing.share});
        record.machine = machine_of(run);
        record.time = run.at("environment").at("time").get<std::string>();
        fmt::print(stderr, "{} on {}, against themselves\n", counted(sources.cells.size(), "cell"), device.info().name);
        ProgressPrinter printer;
        const auto never_decided = [](const LogRatios&) { return false; };
        const VariantOutcome outcome =
            measure_variants(device, {sources.library, sources.library}, sources.configuration, sources.cells, settings,
                             {never_decided, [&](const Progress& progress) { printer(progress); }, {}});
        comparison = compare_variants(outcome, threshold_within);
        code = check_validation(device);
    }
    const int processes = run_processes(options, sources, (1 - share_within) * budget_s, record.cells);
    keep_visible(comparison, record.cells);
    record.between_runs = pool_noise(record.cells, record.time);
    write_noise_record(folder, record);

    if (options.sharing.share) log_warning("{}", describe(DeviceShare::always, "these times"));
    print_results(describe_within_process(comparison, settings.budget_s) + describe_between_runs(record, processes) +
                  fmt::format("kept for `reliefbench compare` in {}\n", folder.string()));
    for (const UncomparedGroup& group : uncompared_by_reason(comparison)) {
        log_warning("not measured within one process, {}: {}", counted(group.cells.size(), "cell"), group.reason);
    }
    if (processes < options.processes) {
        log_warning("{} of {} processes fitted into --budget {}", processes, options.processes, options.budget);
    }
    if (report_false_verdicts(comparison)) code = worse_of(code, ExitCode::regression);
    return code;
}

}  // namespace

void add_selfcheck_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<SelfcheckOptions>();
    CLI::App* command =
        app.add_subcommand("selfcheck", "Find the smallest change that this machine can see, from identical code");
    command
        ->add_option("configuration", options->configuration,
                     "A configuration, or the run.json of an earlier run, - for standard input; default: quick.json")
        ->type_name("CONFIG");
    command
        ->add_option("--processes", options->processes,
                     "Runs of their own, to see how far identical runs lie apart; default: 6")
        ->type_name("N");
    command->add_option("--budget", options->budget, "Time in all, roughly: 90s, 5m, 1h; default: 5m")
        ->type_name("TIME");
    options->cells.add_to(*command);
    options->sampling.add_to(*command);
    options->library.add_to(*command);
    options->device.add_to(*command);
    options->sharing.add_to(*command);
    command->footer(
        "What it finds is kept for this device, driver and CPU, and `reliefbench compare` uses it. Exit code 1 when\n"
        "identical code was called slower or faster.\n"
        "Example: reliefbench selfcheck --budget 10m --processes 10\n");
    command->callback([&chosen, options] { chosen = [options] { return selfcheck(*options); }; });
}

}  // namespace reliefbench
