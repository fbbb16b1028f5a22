#include "cli/advise_request.hpp"

#include "cli/duration.hpp"
#include "cli/figure_choice.hpp"
#include "cli/shared_options.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "store/chosen_figures.hpp"

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cmath>

namespace reliefbench {

namespace {

/// What is better neither way is an Error that names `option`.
const FigureDeclaration& figure_with_direction(const std::string& path, const std::string& option,
                                               std::span<const StoredRun> runs) {
    const FigureDeclaration& figure = chosen_figure(path, option, runs);
    if (figure.better == Better::neither) {
        fail("{}: neither more nor less of {} is better; name a figure that has a better side", option, path);
    }
    return figure;
}

AdviceLimit parse_limit(const std::string& text, std::span<const StoredRun> runs) {
    const std::size_t equals = text.find('=');
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : whole_text_as<double>(std::string_view(text).substr(equals + 1));
    if (!value) fail("--limit: expected FIGURE=VALUE, such as error.uv_texels.max=2, found '{}'", text);
    return {&figure_with_direction(text.substr(0, equals), "--limit", runs), *value};
}

}  // namespace

void AdviseRequestOptions::add_to(CLI::App& command) {
    command.add_option("--budget", budget, "The draw may take so long: 2ms, 500us, 0.1s; a number alone is ms")
        ->type_name("TIME");
    command.add_option("--flip", flip, "FLIP over the footprint may be at most so much, 0 to 1")->type_name("ERROR");
    command.add_option("--uv", uv, "99 % of the UV errors may be at most so many texels")->type_name("TEXELS");
    command.add_option("--shadow", shadow, "The mean error of the lights' visibility may be at most so much")
        ->type_name("ERROR");
    add_repeated_option(command, "--limit", limits,
                        "Any figure of cells.jsonl may be at most so much, or at least where more is better (may be "
                        "repeated)")
        ->type_name("FIGURE=VALUE");
    command
        .add_option("--rank-by", rank_by,
                    fmt::format("The figure by which quality is ranked; default: {} ({} in runs of 0.1.0)",
                                chosen_figures::flip, chosen_figures::flip_of_whole_picture))
        ->type_name("FIGURE");
}

bool AdviseRequestOptions::is_empty() const {
    return budget.empty() && !flip && !uv && !shadow && limits.empty() && rank_by.empty();
}

AdviceRequest AdviseRequestOptions::request(const FigureDeclaration& ranking, std::span<const StoredRun> runs) const {
    AdviceRequest request;
    const auto limit = [&](const FigureDeclaration* figure, const std::optional<double>& value) {
        if (!value) return;
        if (std::isnan(*value)) fail("a limit on {} that is not a number", figure->path);
        request.limits.push_back({figure, *value});
    };
    if (!budget.empty()) limit(&known_figure(chosen_figures::cost), parse_milliseconds(budget, "--budget"));
    limit(&ranking, flip);
    limit(&known_figure(chosen_figures::quality), uv);
    limit(&known_figure(chosen_figures::shadow), shadow);
    for (const std::string& text : limits)
        request.limits.push_back(parse_limit(text, runs));
    if (request.limits.empty()) {
        fail(
            "advise needs at least one limit: --budget 2ms, --flip 0.02, --uv 0.5, --shadow 0.05 or --limit "
            "FIGURE=VALUE");
    }
    request.rank_by = rank_by.empty() ? &ranking : &figure_with_direction(rank_by, "--rank-by", runs);
    return request;
}

}  // namespace reliefbench
