#include "advice/answer.hpp"

#include "core/counted.hpp"
#include "core/suggest.hpp"
#include "report/advice_format.hpp"
#include "report/figure_text.hpp"
#include "report/quality_cost.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

constexpr std::size_t answer_indent = 2;
constexpr std::size_t max_not_told_apart = 3;
constexpr std::size_t max_presets = 3;

struct NarrowedCounts {
    std::size_t measured = 0;
    std::size_t few_rounds = 0;
    std::size_t cut_off = 0;
    std::size_t left_out = 0;
    std::size_t failed = 0;
};

NarrowedCounts count_cells(const NarrowedSweep& sweep) {
    NarrowedCounts counts;
    for (const CellResult& cell : sweep.cells) {
        counts.left_out += cell.status == CellStatus::skipped ? 1 : 0;
        counts.failed += cell.status == CellStatus::failed ? 1 : 0;
        if (cell.status != CellStatus::ok) continue;
        ++counts.measured;
        counts.few_rounds += cell.stop == StopReason::narrowed ? 1 : 0;
        counts.cut_off += cell.stop == StopReason::time ? 1 : 0;
    }
    return counts;
}

std::string shown(double value, const FigureDeclaration& figure) {
    return figure_value_text(value, figure.unit) + figure_unit_text(figure.unit);
}

std::string milliseconds(double ms) {
    return significant(ms) + " ms";
}

/// "FLIP over the footprint 0.034", and the limited figures beside it.
std::string errors_of_setting(const Advice& advice, const AdvisedSetting& setting) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < advice.figures.size(); ++at) {
        const FigureDeclaration& figure = *advice.figures[at];
        const bool is_limited = std::ranges::any_of(advice.request.limits,
                                                    [&](const AdviceLimit& limit) { return limit.figure == &figure; });
        if (figure.path == chosen_figures::cost || (&figure != advice.request.rank_by && !is_limited)) continue;
        if (setting.figures[at])
            words.push_back(fmt::format("{} {}", figure.label, shown(*setting.figures[at], figure)));
    }
    return join(words);
}

std::string price_and_errors(const Advice& advice, const AdvisedSetting& setting) {
    return fmt::format("{}, {}", milliseconds(setting.ms), errors_of_setting(advice, setting));
}

/// "49 % more", "12 % less".
std::string against(double value, double other) {
    const double change = 100 * (value / other - 1);
    return fmt::format("{:.0f} % {}", std::abs(change), change >= 0 ? "more" : "less");
}

class Words {
public:
    Words(const Advice& advice, const NarrowedSweep& sweep, std::size_t columns)
        : advice_(advice), sweep_(sweep), columns_(columns) {}

    std::string view(const std::string& heading, const ViewAdvice& view) {
        text_ = indented(fmt::format("{}, {}:", heading, limits_words(advice_.request)), 0, columns_);
        if (view.best) {
            say_best(view);
        } else if (view.nearest) {
            line(fmt::format("nothing does that; nearest comes {}: {}", view.nearest->setting,
                             price_and_errors(advice_, *view.nearest)));
        } else {
            line("no setting can be advised");
        }
        say_not_told_apart(view);
        if (view.best && view.other_technique) {
            line(fmt::format("of another technique: {}: {}", view.other_technique->setting,
                             price_and_errors(advice_, *view.other_technique)));
        }
        say_next(view);
        say_presets(view);
        return text_;
    }

private:
    void line(const std::string& words) { text_ += indented(words, answer_indent, columns_); }

    void say_best(const ViewAdvice& view) {
        const AdvisedSetting& best = *view.best;
        line(fmt::format("use {}: {} (95 %: {} to {}), {}", best.setting, milliseconds(best.ms),
                         significant(best.ci95_ms.low), significant(best.ci95_ms.high),
                         errors_of_setting(advice_, best)));
        text_ += fmt::format("    {}\n", best.selection.dump());
    }

    void say_not_told_apart(const ViewAdvice& view) {
        if (view.not_told_apart.empty()) return;
        std::vector<std::string> names;
        for (const AdvisedSetting& setting : view.not_told_apart) {
            if (names.size() == max_not_told_apart) break;
            names.push_back(setting.setting);
        }
        const std::size_t more = view.not_told_apart.size() - names.size();
        line(fmt::format("not told apart from it by time{}: {}{}",
                         budget_of(advice_.request) != nullptr && advice_.request.limits.size() == 1 ? " or error" : "",
                         join(names), more > 0 ? fmt::format(" and {} more", more) : ""));
    }

    void say_next(const ViewAdvice& view) {
        if (budget_of(advice_.request) == nullptr) return;
        if (view.next_better.empty()) {
            line("nothing that was measured beyond the budget is better");
            return;
        }
        const AdvisedSetting& next = view.next_better.front();
        const std::optional<AdvisedSetting>& from = view.best ? view.best : view.nearest;
        line(fmt::format("next better: {}: {}{}", next.setting, price_and_errors(advice_, next),
                         from ? ", " + against(next.ms, from->ms) + " time" : ""));
    }

    void say_presets(const ViewAdvice& view) {
        for (std::size_t at = 0; at < std::min(max_presets, view.presets.size()); ++at) {
            const auto& [preset, better, cheaper] = view.presets[at];
            const auto title = sweep_.preset_titles.find(preset.preset);
            std::string words =
                fmt::format("{} ({}): {}", title == sweep_.preset_titles.end() ? preset.preset : title->second,
                            preset.setting, price_and_errors(advice_, preset));
            words += words_of_misses(preset);
            words += better ? fmt::format("; for no more {} has {}{}", better->setting,
                                          price_and_errors(advice_, *better), words_of_misses(*better))
                            : "; nothing that was measured is better for no more";
            line(words);
        }
    }

    static std::string words_of_misses(const AdvisedSetting& setting) {
        if (setting.wrong_hits <= wrong_hits_limit) return "";
        return fmt::format(", misses {} % of its hits", significant(100 * setting.wrong_hits, 2));
    }

    const Advice& advice_;
    const NarrowedSweep& sweep_;
    std::size_t columns_;
    std::string text_;
};

/// "not measured: ..." with how many there are of each.
std::string left_out_words(const NarrowedSweep& sweep, std::size_t columns) {
    std::string text;
    for (const ReasonGroup& group : group_by_reason(sweep.cells, CellStatus::skipped))
        text +=
            indented(fmt::format("{}: {}", counted(group.cells.size(), "cell"), group.reason), answer_indent, columns);
    for (const ReasonGroup& group : group_by_reason(sweep.cells, CellStatus::failed))
        text += indented(fmt::format("{} failed: {}", counted(group.cells.size(), "cell"), group.reason), answer_indent,
                         columns);
    return text;
}

std::string counts_words(const NarrowedSweep& sweep, std::size_t columns) {
    const NarrowedCounts counts = count_cells(sweep);
    std::string text = fmt::format("{} of {} measured", counts.measured, counted(sweep.cells_total, "cell"));
    if (counts.few_rounds > 0)
        text += fmt::format(", {} of them in few rounds, as they were out of the question", counts.few_rounds);
    if (sweep.is_time_over) {
        text += fmt::format(
            "; the time (--time) was over before everything was decided: {} with fewer rounds than they "
            "want, {} not reached",
            counts.cut_off, sweep.cells_total - sweep.cells.size());
    }
    return indented(text, 0, columns) + left_out_words(sweep, columns);
}

}  // namespace

std::string answer_words(const Advice& advice, const NarrowedSweep& sweep, std::size_t columns) {
    if (advice.views.empty())
        return "no cell was measured, so that there is no advice\n" + counts_words(sweep, columns);
    std::string text;
    if (advice.all_views) text += Words(advice, sweep, columns).view("in all of these views", *advice.all_views) + '\n';
    for (const ViewAdvice& view : advice.views)
        text += Words(advice, sweep, columns).view(view.axes.empty() ? "here" : "at " + axes_words(view), view) + '\n';
    text += indented(
        "Times are those of the picture filled with relief, on this device, of the worst azimuth; errors likewise.", 0,
        columns);
    if (!advice.caution.empty()) text += indented("caution: " + advice.caution, 0, columns);
    return text + counts_words(sweep, columns);
}

Json answer_json(const Advice& advice, const NarrowedSweep& sweep) {
    const NarrowedCounts counts = count_cells(sweep);
    Json json = to_json(advice);
    json["cells"] = {{"total", sweep.cells_total},
                     {"measured", counts.measured},
                     {"few_rounds", counts.few_rounds},
                     {"cut_off", counts.cut_off},
                     {"left_out", counts.left_out},
                     {"failed", counts.failed},
                     {"not_reached", sweep.cells_total - sweep.cells.size()}};
    return json;
}

}  // namespace reliefbench
