#include "report/advice_format.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "report/figure_rows.hpp"
#include "report/figure_text.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"
#include "store/view_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

/// Settings named that cannot be told from the best.
constexpr std::size_t settings_named = 3;
constexpr std::size_t line_indent = 2;

/// Of both times that each table begins with.
std::string advice_legend() {
    const FigureDeclaration& cost = known_figure(chosen_figures::cost);
    const FigureDeclaration& over_pixels = known_figure(chosen_figures::ns_per_pixel);
    return fmt::format("{}: {} in the worst view; {}: {}; errors are those of the worst view", cost.short_label,
                       cost.legend, over_pixels.short_label, over_pixels.legend);
}

bool is_draw_time(const FigureDeclaration& figure) {
    return figure.path == chosen_figures::cost;
}

std::string with_unit(double value, const FigureDeclaration& figure) {
    return figure_value_text(value, figure.unit) + figure_unit_text(figure.unit);
}

std::string limit_words(const AdviceLimit& limit) {
    if (is_draw_time(*limit.figure)) return "within " + with_unit(limit.value, *limit.figure);
    const char* const bound = limit.figure->better == Better::higher ? "at least" : "at most";
    return fmt::format("{} {} {}", limit.figure->label, bound, with_unit(limit.value, *limit.figure));
}

}  // namespace

std::string limits_words(const AdviceRequest& request) {
    std::vector<std::string> words;
    for (const AdviceLimit& limit : request.limits) {
        words.push_back(limit_words(limit));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string axes_words(const ViewAdvice& view) {
    if (view.axes.empty()) return view.views.size() == 1 ? view.views.front() : "all views";
    std::vector<std::string> words;
    for (const auto& [axis, value] : view.axes) {
        words.push_back(axis_word(axis, value));
    }
    return fmt::format("{}", fmt::join(words, " "));
}

namespace {

/// "31 %", "31 to 33 %"
std::string share_words(const Interval& share) {
    const std::string low = significant(100 * share.low, 2);
    const std::string high = significant(100 * share.high, 2);
    return low == high ? high + " %" : fmt::format("{} to {} %", low, high);
}

/// What stands before the table of one kind of view.
std::string heading(const Advice& advice, const ViewAdvice& view) {
    std::string text = axes_words(view);
    std::vector<std::string> notes;
    if (view.views.size() > 1) notes.push_back(fmt::format("worst of {} views", view.views.size()));
    const std::optional<AdvisedSetting>& shown = view.best ? view.best : view.nearest;
    if (shown && shown->relief_share) {
        notes.push_back(fmt::format("relief covers {} of the picture", share_words(*shown->relief_share)));
    }
    if (!notes.empty()) text += fmt::format(" ({})", fmt::join(notes, "; "));
    return text + ": " + limits_words(advice.request);
}

/// A role in the answer and who has it.
struct Row {
    std::string role;
    const AdvisedSetting* setting = nullptr;
};

std::vector<Row> rows_of(const ViewAdvice& view) {
    std::vector<Row> rows;
    if (view.best) rows.push_back({"use", &*view.best});
    for (std::size_t at = 0; at < std::min(settings_named, view.not_told_apart.size()); ++at) {
        rows.push_back({"not told apart", &view.not_told_apart[at]});
    }
    if (view.other_technique) rows.push_back({"other technique", &*view.other_technique});
    if (view.nearest) rows.push_back({"nearest", &*view.nearest});
    for (const AdvisedSetting& setting : view.next_better) {
        rows.push_back({"beyond the budget", &setting});
    }
    return rows;
}

std::string value_of(const std::optional<double>& value, const FigureDeclaration& figure) {
    return value ? figure_value_text(*value, figure.unit) : "-";
}

std::string text_of(const std::optional<double>& value) {
    return value ? significant(*value) : "-";
}

std::string table_of(const Advice& advice, const ViewAdvice& view, std::size_t columns) {
    std::vector<FigureColumn> titles{{"", Alignment::left},
                                     {column_title(known_figure(chosen_figures::cost))},
                                     {column_title(known_figure(chosen_figures::ns_per_pixel))}};
    for (const FigureDeclaration* figure : advice.figures) {
        if (is_draw_time(*figure)) continue;
        const std::string unit = figure_unit_text(figure->unit);
        titles.push_back({figure->label + (unit.empty() ? "" : fmt::format(" ({})", unit.substr(1)))});
    }
    std::vector<std::vector<std::string>> figures;
    std::vector<std::string> settings;
    for (const auto& [role, setting] : rows_of(view)) {
        std::vector<std::string>& row = figures.emplace_back();
        row = {role, significant(setting->ms, 4), text_of(setting->ns_per_pixel)};
        for (std::size_t at = 0; at < advice.figures.size(); ++at) {
            if (!is_draw_time(*advice.figures[at])) row.push_back(value_of(setting->figures[at], *advice.figures[at]));
        }
        settings.push_back(setting->setting);
    }
    return figures.empty() ? "" : format_figure_rows(titles, figures, settings, columns, "setting");
}

/// Which limits the nearest is beyond.
std::string missed_limits(const Advice& advice, const AdvisedSetting& nearest) {
    std::vector<std::string> words;
    for (const AdviceLimit& limit : advice.request.limits) {
        const auto at = std::ranges::find(advice.figures, limit.figure) - advice.figures.begin();
        const double value = *nearest.figures[static_cast<std::size_t>(at)];
        if (!is_better(limit.value, value, limit.figure->better)) continue;
        words.push_back(fmt::format("{} {}", limit.figure->label, with_unit(value, *limit.figure)));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

/// What the table does not say.
std::vector<std::string> remarks(const Advice& advice, const ViewAdvice& view) {
    std::vector<std::string> lines;
    if (view.nearest) {
        lines.push_back("nothing does that; the nearest has " + missed_limits(advice, *view.nearest));
    } else if (!view.best) {
        lines.emplace_back("no setting can be advised");
    }
    if (!view.not_told_apart.empty()) {
        const std::size_t count = view.not_told_apart.size();
        const std::string more =
            count > settings_named ? fmt::format(", {} of them shown", settings_named) : std::string();
        lines.push_back(fmt::format("{} not told apart from the first, the 95 % intervals of their times overlap{}",
                                    counted(count, "setting"), more));
    }
    if (budget_of(advice.request) != nullptr && view.next_better.empty() && (view.best || view.nearest)) {
        const bool others = advice.request.limits.size() > 1;
        lines.push_back(std::string("nothing beyond the budget is better") +
                        (others ? " and keeps to the other limits" : ""));
    }
    if (view.wrong > 0) {
        const std::string within = view.wrong_within_limits > 0
                                       ? fmt::format(", {} of them within the limits", view.wrong_within_limits)
                                       : std::string();
        lines.push_back(fmt::format("{} left out{}: missed + false hits above {:g} % of the footprint",
                                    counted(view.wrong, "setting"), within, 100 * wrong_hits_limit));
    }
    if (view.incomplete > 0) {
        lines.push_back(
            fmt::format("{} left out: not measured in all of the views", counted(view.incomplete, "setting")));
    }
    return lines;
}

std::string format_table(const Advice& advice, std::size_t columns) {
    if (advice.views.empty()) return "no cell of the run was measured, so that there is no advice\n";
    std::string text;
    for (const ViewAdvice& view : advice.views) {
        text += indented(heading(advice, view), 0, columns) + table_of(advice, view, columns);
        for (const std::string& line : remarks(advice, view)) {
            text += indented(line, line_indent, columns);
        }
        text += '\n';
    }
    text += indented(advice_legend(), 0, columns);
    if (advice.flip != RankingFlip::footprint) text += indented(caveat_of(advice.flip), 0, columns);
    if (advice.truth_samples > 1) text += indented(truth_words(advice.truth_samples), 0, columns);
    if (!advice.caution.empty()) text += indented("caution: " + advice.caution, 0, columns);
    return text;
}

Json to_json(const Advice& advice, const AdvisedSetting& setting) {
    Json json;
    json["setting"] = setting.setting;
    json["technique"] = setting.technique;
    if (!setting.preset.empty()) json["preset"] = setting.preset;
    json["selection"] = setting.selection;
    json["ms"] = finite_or_null(setting.ms);
    json["ci95_ms"] = {finite_or_null(setting.ci95_ms.low), finite_or_null(setting.ci95_ms.high)};
    json["ns_per_pixel"] = finite_or_null(setting.ns_per_pixel);
    json["relief_share"] = setting.relief_share ? Json{finite_or_null(setting.relief_share->low),
                                                       finite_or_null(setting.relief_share->high)}
                                                : Json(nullptr);
    json["wrong_hits"] = finite_or_null(setting.wrong_hits);
    json["figures"] = Json::object();
    for (std::size_t at = 0; at < advice.figures.size(); ++at) {
        json["figures"][advice.figures[at]->path] = finite_or_null(setting.figures[at]);
    }
    return json;
}

Json to_json(const Advice& advice, const std::optional<AdvisedSetting>& setting) {
    return setting ? to_json(advice, *setting) : Json(nullptr);
}

Json to_json(const Advice& advice, const std::vector<AdvisedSetting>& settings) {
    Json json = Json::array();
    for (const AdvisedSetting& setting : settings) {
        json.push_back(to_json(advice, setting));
    }
    return json;
}

Json to_json(const Advice& advice, const ViewAdvice& view) {
    Json json;
    json["axes"] = Json::object();
    for (const auto& [axis, value] : view.axes) {
        json["axes"][axis] = value;
    }
    json["views"] = view.views;
    json["best"] = to_json(advice, view.best);
    json["not_told_apart"] = to_json(advice, view.not_told_apart);
    json["other_technique"] = to_json(advice, view.other_technique);
    json["nearest"] = to_json(advice, view.nearest);
    json["next_better"] = to_json(advice, view.next_better);
    if (!view.presets.empty()) json["presets"] = Json::array();
    for (const PresetAdvice& each : view.presets)
        json["presets"].push_back({{"preset", to_json(advice, each.preset)},
                                   {"better", to_json(advice, each.better)},
                                   {"cheaper", to_json(advice, each.cheaper)}});
    json["settings"] = view.settings;
    json["incomplete"] = view.incomplete;
    json["wrong"] = view.wrong;
    json["wrong_within_limits"] = view.wrong_within_limits;
    return json;
}

}  // namespace

Json to_json(const Advice& advice) {
    Json json;
    json["rank_by"] = advice.request.rank_by->path;
    json["limits"] = Json::array();
    for (const AdviceLimit& limit : advice.request.limits) {
        json["limits"].push_back(
            {{"figure", limit.figure->path}, {"better", to_string(limit.figure->better)}, {"value", limit.value}});
    }
    json["note"] = advice.flip == RankingFlip::footprint ? Json(nullptr) : Json(caveat_of(advice.flip));
    json["truth_samples"] = advice.truth_samples;
    json["caution"] = advice.caution.empty() ? Json(nullptr) : Json(advice.caution);
    json["views"] = Json::array();
    for (const ViewAdvice& view : advice.views) {
        json["views"].push_back(to_json(advice, view));
    }
    if (advice.all_views) json["all_views"] = to_json(advice, *advice.all_views);
    return json;
}

const std::vector<std::string>& advice_format_names() {
    static const std::vector<std::string> names = {"table", "json"};
    return names;
}

AdviceFormat parse_advice_format(const std::string& name) {
    const std::vector<std::string>& names = advice_format_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        fail("there is no format '{}'{}; the formats are {}", name, did_you_mean(name, names), join(names));
    }
    return static_cast<AdviceFormat>(found - names.begin());
}

std::string format_advice(const Advice& advice, AdviceFormat format, std::size_t columns) {
    constexpr int spaces = 2;
    if (format == AdviceFormat::table) return format_table(advice, columns);
    return to_json(advice).dump(spaces, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace reliefbench
