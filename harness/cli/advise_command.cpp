#include "cli/command.hpp"
#include "cli/duration.hpp"
#include "cli/figure_choice.hpp"
#include "cli/results.hpp"
#include "cli/shared_options.hpp"
#include "cli/stored_runs.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/suggest.hpp"
#include "report/advice_format.hpp"
#include "store/chosen_figures.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

namespace reliefbench {

namespace {

struct AdviseOptions {
    std::string run;
    std::string budget;
    std::optional<double> flip;
    std::optional<double> uv;
    std::optional<double> shadow;
    std::vector<std::string> limits;
    std::string rank_by;
    std::vector<std::string> cells;
    std::string format = "table";
};

/// What is better neither way is an Error that names `option`.
const FigureDeclaration& figure_with_direction(const std::string& path, const std::string& option,
                                               const StoredRun& run) {
    const FigureDeclaration& figure = chosen_figure(path, option, {&run, 1});
    if (figure.better == Better::neither) {
        fail("{}: neither more nor less of {} is better; name a figure that has a better side", option, path);
    }
    return figure;
}

AdviceLimit parse_limit(const std::string& text, const StoredRun& run) {
    const std::size_t equals = text.find('=');
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : whole_text_as<double>(std::string_view(text).substr(equals + 1));
    if (!value) fail("--limit: expected FIGURE=VALUE, such as error.uv_texels.max=2, found '{}'", text);
    return {&figure_with_direction(text.substr(0, equals), "--limit", run), *value};
}

AdviceRequest request_of(const AdviseOptions& options, const StoredRun& run) {
    const std::vector<CellResult>& cells = run.run.cells;
    AdviceRequest request;
    const auto limit = [&](const FigureDeclaration* figure, const std::optional<double>& value) {
        if (!value) return;
        if (std::isnan(*value)) fail("a limit on {} that is not a number", figure->path);
        request.limits.push_back({figure, *value});
    };
    if (!options.budget.empty()) {
        limit(&known_figure(chosen_figures::cost), parse_milliseconds(options.budget, "--budget"));
    }
    limit(&ranking_figure(cells), options.flip);
    limit(&known_figure(chosen_figures::quality), options.uv);
    limit(&known_figure(chosen_figures::shadow), options.shadow);
    for (const std::string& text : options.limits) {
        request.limits.push_back(parse_limit(text, run));
    }
    if (request.limits.empty()) {
        fail(
            "advise needs at least one limit: --budget 2ms, --flip 0.02, --uv 0.5, --shadow 0.05 or --limit "
            "FIGURE=VALUE");
    }
    request.rank_by =
        options.rank_by.empty() ? &ranking_figure(cells) : &figure_with_direction(options.rank_by, "--rank-by", run);
    return request;
}

ExitCode advise_from_run(const AdviseOptions& options) {
    const AdviceFormat format = parse_advice_format(options.format);
    std::vector<StoredRun> runs = read_stored_runs({options.run});
    keep_cells(runs, options.cells);
    const std::vector<CellResult>& cells = runs.front().run.cells;
    print_results(
        format_advice(advise(cells, request_of(options, runs.front()), runs.front().run.run), format, table_columns()));
    return ExitCode::done;
}

}  // namespace

void add_advise_command(CLI::App& app, ChosenCommand& chosen) {
    const auto options = std::make_shared<AdviseOptions>();
    CLI::App* command = app.add_subcommand(
        "advise", "What to use, from a stored run: the best for a budget, the cheapest for an error");
    command->add_option("run", options->run, "Folder of a run")->required()->type_name("RUN");
    command
        ->add_option("--budget", options->budget, "The draw may take so long: 2ms, 500us, 0.1s; a number alone is ms")
        ->type_name("TIME");
    command->add_option("--flip", options->flip, "FLIP over the footprint may be at most so much, 0 to 1")
        ->type_name("ERROR");
    command->add_option("--uv", options->uv, "99 % of the UV errors may be at most so many texels")
        ->type_name("TEXELS");
    command->add_option("--shadow", options->shadow, "The mean error of the lights' visibility may be at most so much")
        ->type_name("ERROR");
    add_repeated_option(*command, "--limit", options->limits,
                        "Any figure of cells.jsonl may be at most so much, or at least where more is better (may be "
                        "repeated)")
        ->type_name("FIGURE=VALUE");
    command
        ->add_option("--rank-by", options->rank_by,
                     fmt::format("The figure by which quality is ranked; default: {} ({} in runs of 0.1.0)",
                                 chosen_figures::flip, chosen_figures::flip_of_whole_picture))
        ->type_name("FIGURE");
    add_repeated_option(*command, "--cell", options->cells,
                        "Only cells whose id contains this (may be repeated; any may match)")
        ->type_name("TEXT");
    command->add_option("--format", options->format, "How to write the result; default: table")
        ->type_name(join(advice_format_names(), "|"));
    command->footer(
        "All limits must be kept. With a budget alone the best within it is advised, and the next better steps beyond\n"
        "  it are shown; with a limit on an error the cheapest that keeps to all limits. Kinds of view (angle,\n"
        "  resolution, ...) are answered one by one, each by the worst of its height maps and azimuths. Settings with\n"
        "  missed + false hits above 0.5 % of the footprint are no advice.\n"
        "Exit code 0, whatever is advised.\n"
        "Example: reliefbench advise results/mine --budget 2ms\n"
        "Example: reliefbench advise results/mine --flip 0.02 --uv 0.5 --format json\n");
    command->callback([&chosen, options] { chosen = [options] { return advise_from_run(*options); }; });
}

}  // namespace reliefbench
