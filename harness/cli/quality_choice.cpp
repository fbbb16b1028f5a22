#include "cli/quality_choice.hpp"

#include "cli/figure_choice.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/split.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace reliefbench {

namespace {

constexpr const char* quality_option = "--quality-figures";

const FigureDeclaration* parse_term(const std::string& path, std::span<const StoredRun> runs) {
    const FigureDeclaration& figure = chosen_figure(path, quality_option, runs);
    if (is_time(figure)) fail("{}: {} is a time, which has a verdict of its own", quality_option, path);
    if (figure.better == Better::neither) {
        fail("{}: of {} neither less nor more is better (`reliefbench list figures`)", quality_option, path);
    }
    return &figure;
}

void parse_tolerance(const std::string& text, FigureTolerance& tolerance) {
    std::string_view digits = text;
    const bool percent = digits.ends_with('%');
    if (percent) digits.remove_suffix(1);
    const auto number = whole_text_as<double>(digits);
    if (!number || !std::isfinite(*number) || *number < 0) {
        fail("{}: expected a tolerance such as 0.05 (in the figure's unit) or 5% (of its value), found '{}'",
             quality_option, text);
    }
    (percent ? tolerance.relative : tolerance.absolute) = percent ? *number / 100 : *number;
}

DecidingFigure parse_figure(const std::string& text, std::span<const StoredRun> runs) {
    const std::vector<std::string> parts = split(text, ':');
    std::vector<const FigureDeclaration*> terms;
    for (const std::string& path : split(parts.front(), '+')) {
        terms.push_back(parse_term(path, runs));
        if (terms.back()->unit != terms.front()->unit || terms.back()->better != terms.front()->better) {
            fail("{}: {} and {} are of different units or directions, and their sum means nothing", quality_option,
                 terms.front()->path, path);
        }
    }
    DecidingFigure figure = deciding_figure(std::move(terms));
    if (parts.size() > 1) figure.tolerance = {};
    for (std::size_t part = 1; part < parts.size(); ++part) {
        parse_tolerance(parts[part], figure.tolerance);
    }
    return figure;
}

}  // namespace

void QualityChoice::add_to(CLI::App& command) {
    command
        .add_option("--quality-figures", figures,
                    "The figures that decide whether quality is better or worse, as `list figures` names them, in "
                    "place of UV error, missed and false hits, FLIP, shadows and motion; NAME:0.1, NAME:5% or "
                    "NAME:0.1:5% sets what a change has to exceed, NAME+NAME is a sum")
        ->type_name("NAME,NAME...");
}

std::vector<DecidingFigure> QualityChoice::deciding_figures(std::span<const StoredRun> runs) const {
    if (figures.empty()) return default_deciding_figures();
    std::vector<DecidingFigure> chosen;
    for (const std::string& text : split(figures, ',')) {
        chosen.push_back(parse_figure(text, runs));
        const std::string name = chosen.back().name();
        if (std::count_if(chosen.begin(), chosen.end(),
                          [&](const DecidingFigure& each) { return each.name() == name; }) > 1) {
            fail("{}: {} is named twice", quality_option, name);
        }
    }
    return chosen;
}

}  // namespace reliefbench
