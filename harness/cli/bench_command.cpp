#include "cli/bench_cells.hpp"
#include "cli/command.hpp"
#include "cli/device_lock.hpp"
#include "cli/run_sources.hpp"
#include "cli/shared_options.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "measure/base_records.hpp"
#include "measure/shared_inputs.hpp"
#include "report/benchmark_counters.hpp"
#include "store/environment.hpp"

#include <benchmark/benchmark.h>
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>

namespace reliefbench {

namespace {

struct BenchOptions {
    std::string configuration;
    CellChoice cells;
    SamplingChoice sampling;
    TechniqueOptions library;
    DeviceChoice device;
    DeviceSharing sharing;
    /// What is for Google Benchmark.
    std::vector<std::string> flags;
};

/// The value of a flag of Google Benchmark (without "benchmark_"): the last on the command line, else its environment
/// variable's.
std::optional<std::string> flag_value(const std::vector<std::string>& flags, const std::string& name) {
    const std::string flag = "--benchmark_" + name;
    for (auto argument = flags.rbegin(); argument != flags.rend(); ++argument) {
        if (*argument == flag) return "true";
        if (argument->starts_with(flag + "=")) return argument->substr(flag.size() + 1);
    }
    std::string variable = "BENCHMARK_" + name;
    std::transform(variable.begin(), variable.end(), variable.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    const char* value = std::getenv(variable.c_str());
    return value ? std::optional<std::string>(value) : std::nullopt;
}

bool is_set(const std::vector<std::string>& flags, const std::string& name) {
    const std::vector<std::string> off = {"false", "0", "no", "off", "f", "n"};
    const std::optional<std::string> value = flag_value(flags, name);
    return value && std::find(off.begin(), off.end(), *value) == off.end();
}

/// Google Benchmark ends the program by itself for these, with exit codes that mean something else here.
void check_flags(const std::vector<std::string>& flags) {
    const auto check_choice = [&](const std::string& name, const std::vector<std::string>& choices) {
        const std::string value = flag_value(flags, name).value_or(choices.front());
        if (std::find(choices.begin(), choices.end(), value) == choices.end()) {
            fail("--benchmark_{}={}: it takes {}", name, value, join(choices));
        }
    };
    check_choice("format", {"console", "json", "csv"});
    check_choice("out_format", {"json", "console", "csv"});
    check_choice("time_unit", {"ms", "ns", "us", "s"});
    if (flag_value(flags, "color") == "") fail("--benchmark_color: it takes auto, true, false");
    if (const auto file = flag_value(flags, "out"); file && !file->empty()) {
        if (!std::ofstream(*file, std::ios::app)) fail("cannot write '{}': check the folder, or name another", *file);
    }
}

/// Flags that Google Benchmark does not know, or whose values it cannot read, are an Error.
void initialize_google_benchmark(const std::vector<std::string>& flags) {
    check_flags(flags);
    // Google Benchmark keeps the pointer to the first for its context.
    static std::string program = "reliefbench";
    std::vector<std::string> arguments = flags;
    std::vector<char*> pointers{program.data()};
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    int count = static_cast<int>(pointers.size());
    pointers.push_back(nullptr);
    benchmark::SetDefaultTimeUnit(benchmark::kMillisecond);
    benchmark::Initialize(&count, pointers.data());
    if (count > 1) {
        fail("bench does not take '{}'; see `reliefbench bench --help` for the flags and their values", pointers[1]);
    }
}

/// A cell's id as Google Benchmark writes names: parts between slashes, and nothing that its filter, a regular
/// expression, reads as anything but itself (but the dot, which also matches itself).
std::string benchmark_name(const std::string& cell_id) {
    std::string name;
    for (std::size_t at = 0; at < cell_id.size(); ++at) {
        if (cell_id.compare(at, 3, " | ") == 0) {
            name += '/';
            at += 2;
        } else if (cell_id[at] == ' ') {
            name += '/';
        } else {
            const bool plain = std::isalnum(static_cast<unsigned char>(cell_id[at])) != 0;
            name += plain || std::string("_-=.:").find(cell_id[at]) != std::string::npos ? cell_id[at] : '_';
        }
    }
    return name;
}

void add_counters(benchmark::State& state, const CellResult& cell) {
    for (const auto& [name, value] : benchmark_counters(cell))
        state.counters[name] = value;
}

/// What one iteration is. The time reported is always that of one draw.
enum class Iteration {
    /// One sample, so that a short draw's sample repeats it: their count is fixed.
    sample,
    /// One draw, so that Google Benchmark's least time counts all the GPU's.
    draw,
};

void measure(benchmark::State& state, BenchCells& cells, std::size_t index, Iteration iteration) {
    const CellResult& cell = cells.prepare(index);
    if (cell.status != CellStatus::ok) {
        state.SkipWithError(describe_ending(cell).c_str());
        return;
    }
    add_counters(state, cell);
    const int batch = iteration == Iteration::draw ? cells.repeats() : 1;
    while (state.KeepRunningBatch(batch)) {
        const std::optional<double> draw_ms = cells.time_draw();
        if (!draw_ms) {
            state.SkipWithError(describe_ending(cell).c_str());
            return;
        }
        state.SetIterationTime(batch * *draw_ms / 1000);
    }
}

/// Google Benchmark divides by means that may be zero for its coefficients of variation, and prints a bare NaN, which
/// is not JSON: what is not finite is left out.
class FiniteJsonReporter : public benchmark::JSONReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        std::vector<Run> finite;
        for (Run run : runs) {
            if (!std::isfinite(run.real_accumulated_time) || !std::isfinite(run.cpu_accumulated_time)) continue;
            std::erase_if(run.counters, [](const auto& counter) { return !std::isfinite(counter.second.value); });
            finite.push_back(std::move(run));
        }
        benchmark::JSONReporter::ReportRuns(finite);
    }
};

std::size_t run_benchmarks(const std::vector<std::string>& flags) {
    const bool json_display = flag_value(flags, "format") == "json";
    const bool json_file =
        !flag_value(flags, "out").value_or("").empty() && flag_value(flags, "out_format").value_or("json") == "json";
    FiniteJsonReporter display;
    FiniteJsonReporter file;
    return benchmark::RunSpecifiedBenchmarks(json_display ? &display : nullptr, json_file ? &file : nullptr);
}

void add_context(const gpu::DeviceInfo& device, bool shares_device) {
    benchmark::AddCustomContext("device", device.name);
    benchmark::AddCustomContext("driver", device.driver);
    benchmark::AddCustomContext("driver_version", device.driver_version);
    benchmark::AddCustomContext("tool_version", collect_environment().tool_version);
    if (shares_device) benchmark::AddCustomContext("shared_device", "true");
}

ExitCode bench(const BenchOptions& options) {
    const std::string configuration =
        options.configuration.empty() ? (configuration_root() / "quick.json").string() : options.configuration;
    RunSources sources = read_run_sources(read_configuration_text(configuration), options.cells, options.library);
    set_sampling(sources.configuration, options.sampling.settings);
    initialize_google_benchmark(options.flags);

    const bool only_list = is_set(options.flags, "list_tests");
    std::optional<gpu::Device> device;
    std::optional<DeviceLock> lock;
    std::optional<BenchCells> cells;
    if (!only_list) {
        inspect_height_maps(sources.cells);
        inspect_bases(sources.cells);
        device.emplace(options.device.options);
        lock = options.sharing.lock(device->info());
        add_context(device->info(), options.sharing.share);
        cells.emplace(*device, sources.library, sources.configuration, sources.cells);
    }
    const bool least_time_given = flag_value(options.flags, "min_time").has_value();
    const Iteration iteration = least_time_given ? Iteration::draw : Iteration::sample;
    const SamplingSettings& sampling = sources.configuration.sampling;
    for (std::size_t index = 0; index < sources.cells.size(); ++index) {
        benchmark::internal::Benchmark* registered = benchmark::RegisterBenchmark(
            benchmark_name(sources.cells[index].id).c_str(),
            [&cells, index, iteration](benchmark::State& state) { measure(state, *cells, index, iteration); });
        registered->UseManualTime();
        // Under manual time Google Benchmark looks at the GPU's time only, and would run short draws for minutes.
        if (!least_time_given) registered->Iterations(std::max(1, sampling.rounds * sampling.samples_per_visit));
    }
    const std::size_t matched = run_benchmarks(options.flags);
    benchmark::Shutdown();
    if (matched == 0) {
        fail("--benchmark_filter={}: no cell is called so; --benchmark_list_tests shows the names",
             flag_value(options.flags, "filter").value_or(""));
    }
    if (only_list) return ExitCode::done;
    for (const CellResult* cell : cells->failed()) {
        fmt::print(stderr, "reliefbench: cell failed: {}: {}\n", cell->cell, cell->reason);
    }
    return worse_of(cells->failed().empty() ? ExitCode::done : ExitCode::cells_failed, check_validation(*device));
}

}  // namespace

void add_bench_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<BenchOptions>();
    CLI::App* command = app.add_subcommand("bench", "Measure cells as Google Benchmarks, with all of its flags");
    command
        ->add_option("--config", options->configuration,
                     "A configuration, or the run.json of an earlier run, - for standard input; default: the shipped "
                     "configs/quick.json")
        ->type_name("CONFIG");
    options->cells.add_to(*command);
    options->sampling.add_to(*command);
    options->library.add_to(*command);
    options->device.add_to(*command);
    options->sharing.add_to(*command);
    command->allow_extras();
    command->footer(
        "Google Benchmark's flags: --benchmark_filter=REGEX, --benchmark_list_tests, --benchmark_repetitions=N,\n"
        "--benchmark_enable_random_interleaving, --benchmark_report_aggregates_only, "
        "--benchmark_format=console|json|csv,\n"
        "--benchmark_out=FILE, --benchmark_out_format=json|console|csv, --benchmark_context=KEY=VALUE,\n"
        "--benchmark_time_unit=ns|us|ms|s, --benchmark_counters_tabular, --benchmark_min_time=SECONDS and the rest.\n"
        "The time is the GPU's of one draw. An iteration is a sample, and there are rounds times samples per\n"
        "visit of the configuration; with --benchmark_min_time it is a draw, and they go on for that much GPU time.\n"
        "Exit code 4 when some cells failed.\n"
        "Example: reliefbench bench --filter technique=pom,qdm --benchmark_repetitions=5 --benchmark_out=mine.json\n");
    command->callback([&chosen, options, command] {
        options->flags = command->remaining();
        chosen = [options] { return bench(*options); };
    });
}

}  // namespace reliefbench
