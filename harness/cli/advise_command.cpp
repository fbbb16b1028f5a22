#include "cli/advise_map.hpp"
#include "cli/advise_request.hpp"
#include "cli/command.hpp"
#include "cli/results.hpp"
#include "cli/shared_options.hpp"
#include "cli/stored_runs.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/advice_format.hpp"
#include "report/engine_answers.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace reliefbench {

namespace {

struct AdviseOptions {
    std::string run;
    AdviseRequestOptions request;
    std::vector<std::string> cells;
    std::string format = "table";
    AdviseMapOptions map;
    /// Those of `map`.
    std::vector<const CLI::Option*> of_map;
    std::vector<std::string> command_line;
};

ExitCode advise_from_run(const AdviseOptions& options) {
    const AdviceFormat format = parse_advice_format(options.format);
    std::vector<StoredRun> runs = read_stored_runs({options.run});
    keep_cells(runs, options.cells);
    const std::vector<CellResult>& cells = runs.front().run.cells;
    if (options.request.is_empty()) {
        const Json& record = runs.front().run.run;
        if (const std::optional<Advice> engines = answer_engines(cells, record)) {
            print_results(format == AdviceFormat::json ? to_json(*engines).dump(2) + '\n'
                                                       : format_engines(*engines, record, table_columns()));
            return ExitCode::done;
        }
    }
    const AdviceRequest request = options.request.request(ranking_figure(cells), runs);
    print_results(format_advice(advise(cells, request, runs.front().run.run), format, table_columns()));
    return ExitCode::done;
}

ExitCode advise_from_map_or_run(const AdviseOptions& options, const CLI::App& command) {
    const bool has_map = command.count("--map") > 0;
    if (has_map == (command.count("run") > 0))
        fail("advise needs the folder of a run, or a height map to measure: --map heights.png");
    if (!has_map) {
        for (const CLI::Option* option : options.of_map) {
            if (option->count() > 0 && option->get_envname().empty())
                fail("{} says how a height map is measured: give it with --map", option->get_name());
        }
        return advise_from_run(options);
    }
    if (command.count("--cell") > 0) fail("--cell chooses cells of a run; with --map choose by --filter");
    const AdviceFormat format = parse_advice_format(options.format);
    return advise_from_map(options.map, options.request, format == AdviceFormat::json, options.command_line);
}

}  // namespace

void add_advise_command(CLI::App& app, ChosenCommand& chosen, const std::vector<std::string>& command_line) {
    const auto options = std::make_shared<AdviseOptions>();
    options->command_line = command_line;
    CLI::App* command =
        app.add_subcommand("advise",
                           "What to use: the best for a budget, the cheapest for an error; for a height map, which is "
                           "measured for it, or from a stored run");
    command->add_option("run", options->run, "Folder of a run, where there is one to ask")->type_name("RUN");
    command
        ->add_option("--map", options->map.map,
                     "Measure this height map: an image file, the name of a generated one (`list heightmaps`), or an "
                     "object as the axis heightmap takes it")
        ->type_name("FILE");
    options->request.add_to(*command);
    add_repeated_option(*command, "--cell", options->cells,
                        "Of a run, only cells whose id contains this (may be repeated; any may match)")
        ->type_name("TEXT");
    command->add_option("--format", options->format, "How to write the result; default: table")
        ->type_name(join(advice_format_names(), "|"));
    const std::size_t before_map = command->get_options().size();
    options->map.add_to(*command);
    for (const CLI::Option* option : std::as_const(*command).get_options()) {
        options->of_map.push_back(option);
    }
    options->of_map.erase(options->of_map.begin(), options->of_map.begin() + static_cast<std::ptrdiff_t>(before_map));
    command->footer(
        "All limits must be kept. With a budget alone the best within it is advised, and the next better steps beyond\n"
        "  it are shown; with a limit on an error the cheapest that keeps to all limits. Kinds of view (angle,\n"
        "  resolution, ...) are answered one by one, each by the worst of its height maps and azimuths. Settings with\n"
        "  missed + false hits above 0.5 % of the footprint are no advice.\n"
        "Without any limit, of a run with presets: what each pays and misses, and what is better for no more time.\n"
        "With --map all techniques are measured that fit the map and the device, with sample counts on a ladder and\n"
        "  with engines' presets, from three azimuths; what cannot be the answer is dropped as soon as that shows. It\n"
        "  ends when everything is decided, or the time (--time) is over. The same command goes on where it ended.\n"
        "Exit code 0, whatever is advised.\n"
        "Example: reliefbench advise --map heights.png --budget 2ms --view-angle 60,75 --resolution 1280x720\n"
        "Example: reliefbench advise --map heights.png --albedo colours.png --height-scale 0.1 --flip 0.02\n"
        "Example: reliefbench advise results/mine --budget 2ms\n"
        "Example: reliefbench advise results/engines\n"
        "Example: reliefbench advise results/mine --flip 0.02 --uv 0.5 --format json\n");
    command->callback([&chosen, options, command] {
        chosen = [options, command] { return advise_from_map_or_run(*options, *command); };
    });
}

}  // namespace reliefbench
