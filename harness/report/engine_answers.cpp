#include "report/engine_answers.hpp"

#include "core/json_lookup.hpp"
#include "report/advice_format.hpp"
#include "report/cautions.hpp"
#include "report/figure_rows.hpp"
#include "report/figure_text.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace reliefbench {

namespace {

constexpr std::size_t note_indent = 2;

std::string title_of(const AdvisedSetting& preset, const Json& record) {
    const Json title = value_at(record, {"presets", preset.technique.c_str(), preset.preset.c_str(), "title"});
    return title.is_string() ? title.get<std::string>() : preset.preset;
}

std::vector<std::string> figures_of(const Advice& advice, const std::string& role, const AdvisedSetting& setting) {
    std::vector<std::string> row{role, significant(setting.ms, 4),
                                 setting.ns_per_pixel ? significant(*setting.ns_per_pixel) : undefined};
    for (std::size_t at = 0; at < advice.figures.size(); ++at) {
        const std::optional<double>& value = setting.figures[at];
        row.push_back(value ? figure_value_text(*value, advice.figures[at]->unit) : undefined);
    }
    row.push_back(significant(100 * setting.wrong_hits));
    return row;
}

std::string table_of_engines(const Advice& advice, const ViewAdvice& view, const Json& record, std::size_t columns) {
    std::vector<FigureColumn> titles{{"", Alignment::left},
                                     {column_title(known_figure(chosen_figures::cost))},
                                     {column_title(known_figure(chosen_figures::ns_per_pixel))}};
    for (const FigureDeclaration* figure : advice.figures) {
        const std::string unit = figure_unit_text(figure->unit);
        titles.push_back({figure->label + (unit.empty() ? "" : fmt::format(" ({})", unit.substr(1)))});
    }
    titles.push_back({"wrong hits (%)"});
    std::vector<std::vector<std::string>> figures;
    std::vector<std::string> settings;
    const auto add = [&](const std::string& role, const AdvisedSetting& setting) {
        figures.push_back(figures_of(advice, role, setting));
        settings.push_back(setting.setting);
    };
    for (const PresetAdvice& each : view.presets) {
        add(title_of(each.preset, record), each.preset);
        if (each.better) add("  better, no slower", *each.better);
        if (each.cheaper && (!each.better || each.cheaper->setting != each.better->setting))
            add("  as good, faster", *each.cheaper);
    }
    return format_figure_rows(titles, figures, settings, columns, "setting");
}

/// What presets leave out, once each.
std::string notes_of(const Advice& advice, const Json& record, std::size_t columns) {
    std::string text;
    std::set<std::string> noted;
    for (const ViewAdvice& view : advice.views) {
        for (const PresetAdvice& each : view.presets) {
            const Json note = value_at(
                record, {"presets", each.preset.technique.c_str(), each.preset.preset.c_str(), "not_expressed"});
            if (!note.is_string() || note == "" || !noted.insert(each.preset.preset).second) continue;
            text += indented(fmt::format("{}: {}", title_of(each.preset, record), note.get<std::string>()), note_indent,
                             columns);
        }
    }
    return text.empty() ? text : "What presets do not express:\n" + text;
}

}  // namespace

std::optional<Advice> answer_engines(const std::vector<CellResult>& cells, const Json& record) {
    const FigureDeclaration& figure = ranking_figure(cells);
    const bool has_answer = std::ranges::any_of(cells, [&](const CellResult& cell) {
        return !cell.preset.empty() && cell.status == CellStatus::ok && value_of(figure, cell);
    });
    if (!has_answer) return std::nullopt;
    AdviceRequest request;
    request.rank_by = &figure;
    Advice advice = advise(cells, request, record);
    for (ViewAdvice& view : advice.views)
        std::ranges::stable_sort(view.presets, {}, [](const PresetAdvice& each) { return each.preset.ms; });
    return advice;
}

std::string format_engines(const Advice& advice, const Json& record, std::size_t columns) {
    std::string text;
    for (const ViewAdvice& view : advice.views) {
        if (view.presets.empty()) continue;
        const std::string worst = view.views.size() > 1 ? fmt::format(" (worst of {} views)", view.views.size()) : "";
        text += indented(axes_words(view) + worst, 0, columns) + table_of_engines(advice, view, record, columns) + '\n';
    }
    text += indented(
        "better, no slower: of the settings of no preset that cannot be told to take more time, nor take over 5 % "
        "longer, the least error, where that can be told from the preset's; as good, faster: the fastest whose error "
        "cannot be told to be more. Their wrong hits (missed and false, per cent of the footprint) are at most 0.5 % "
        "or, where nothing else is there, no more than the preset's. What is not there was not measured.",
        0, columns);
    text += notes_of(advice, record, columns);
    if (!advice.caution.empty()) text += indented("caution: " + advice.caution, 0, columns);
    return text;
}

}  // namespace reliefbench
