#include "report/advice.hpp"

#include "compare/deciding_figures.hpp"
#include "core/error.hpp"
#include "core/split.hpp"
#include "report/cautions.hpp"
#include "report/quality_cost.hpp"
#include "report/view_groups.hpp"
#include "store/chosen_figures.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

constexpr std::size_t next_steps = 3;
/// However wide the intervals are, what takes more than this longer by its median is not called as fast.
constexpr double same_time_tolerance = 0.05;

bool can_be_told_apart(double a, double b, const FigureTolerance& tolerance) {
    return size_in_tolerances(a, b, tolerance) > 1;
}

/// "512x256"; empty where it is none.
std::optional<double> pixels_of(const Json& resolution) {
    if (!resolution.is_string()) return std::nullopt;
    const auto text = resolution.get<std::string>();
    int width = 0;
    int height = 0;
    const auto [x, error] = std::from_chars(text.data(), text.data() + text.size(), width);
    if (error != std::errc() || x == text.data() + text.size()) return std::nullopt;
    const auto [end, second_error] = std::from_chars(x + 1, text.data() + text.size(), height);
    if (second_error != std::errc() || width <= 0 || height <= 0) return std::nullopt;
    return static_cast<double>(width) * height;
}

std::optional<double> relief_share(const CellResult& cell) {
    const std::optional<double> covered = value_of(chosen_figures::covered_pixels, cell);
    if (!covered || !cell.axes.is_object() || !cell.axes.contains("resolution")) return std::nullopt;
    const std::optional<double> pixels = pixels_of(cell.axes["resolution"]);
    if (!pixels) return std::nullopt;
    return *covered / *pixels;
}

/// By the words of the setting: what it names is what is not at its default.
Json selection_of(const std::string& setting, const CellResult& cell) {
    Json selection = {{"technique", cell.technique}};
    if (!cell.preset.empty()) selection["preset"] = cell.preset;
    for (const std::string& word : split(setting, ' ')) {
        const std::string name = word.substr(0, word.find('='));
        if (name != word && cell.parameters.is_object() && cell.parameters.contains(name))
            selection["parameters"][name] = cell.parameters[name];
    }
    return selection;
}

/// Answers for the settings of one group.
class Adviser {
public:
    Adviser(const Advice& advice, const ViewGroup& group) : advice_(advice), request_(advice.request) {
        answer_.axes = group.axes;
        std::vector<std::string> order;
        std::map<std::string, std::vector<const CellResult*>> by_setting;
        for (const CellResult* cell : group.cells) {
            const auto [setting, view] = split_cell_id(cell->cell);
            if (std::ranges::find(answer_.views, view) == answer_.views.end()) answer_.views.push_back(view);
            if (!by_setting.contains(setting)) order.push_back(setting);
            if (has_all_figures(*cell)) by_setting[setting].push_back(cell);
        }
        for (const std::string& setting : order) {
            const std::vector<const CellResult*>& cells = by_setting[setting];
            if (cells.size() == answer_.views.size()) {
                add(worst_of(setting, cells));
            } else {
                ++answer_.incomplete;
            }
        }
    }

    ViewAdvice answer() {
        std::vector<const AdvisedSetting*> kept;
        for (const AdvisedSetting& setting : settings_) {
            if (keeps_to_limits(setting)) kept.push_back(&setting);
        }
        if (const AdvisedSetting* const best = best_of(kept)) {
            answer_.best = *best;
            answer_not_told_apart(kept, *best);
            std::erase_if(kept, [&](const AdvisedSetting* setting) { return setting->technique == best->technique; });
            if (const AdvisedSetting* const other = best_of(kept)) answer_.other_technique = *other;
        } else {
            answer_nearest();
        }
        if (budget_of(request_) != nullptr) answer_next_better();
        answer_presets();
        return std::move(answer_);
    }

private:
    bool has_all_figures(const CellResult& cell) const {
        const auto lacks = [&](const FigureDeclaration* figure) { return !value_of(*figure, cell); };
        return wrong_hits(cell) && !lacks(request_.rank_by) &&
               std::ranges::none_of(request_.limits, lacks, &AdviceLimit::figure);
    }

    AdvisedSetting worst_of(const std::string& setting, const std::vector<const CellResult*>& cells) const {
        AdvisedSetting worst;
        worst.setting = setting;
        worst.technique = cells.front()->technique;
        worst.preset = cells.front()->preset;
        worst.selection = selection_of(setting, *cells.front());
        worst.figures.resize(advice_.figures.size());
        for (const CellResult* cell : cells) {
            const PassTiming& draw = *draw_timing(*cell);
            if (cell == cells.front() || draw.median_ms > worst.ms) {
                worst.ms = draw.median_ms;
                worst.ci95_ms = draw.ci95_ms;
            }
            worst.wrong_hits = std::max(worst.wrong_hits, wrong_hits(*cell).value_or(0));
            if (cell->ns_per_pixel) worst.ns_per_pixel = std::max(worst.ns_per_pixel.value_or(0), *cell->ns_per_pixel);
            if (const auto share = relief_share(*cell)) {
                const Interval known = worst.relief_share.value_or(Interval{*share, *share});
                worst.relief_share = Interval{std::min(known.low, *share), std::max(known.high, *share)};
            }
            for (std::size_t at = 0; at < advice_.figures.size(); ++at) {
                const FigureDeclaration& figure = *advice_.figures[at];
                const std::optional<double> value = value_of(figure, *cell);
                std::optional<double>& known = worst.figures[at];
                if (value && (!known || is_better(*known, *value, figure.better))) known = value;
            }
        }
        return worst;
    }

    void add(AdvisedSetting setting) {
        ++answer_.settings;
        if (setting.preset.empty()) {
            without_preset_.push_back(setting);
        } else {
            answer_.presets.push_back({.preset = setting, .better = {}, .cheaper = {}});
        }
        if (setting.wrong_hits > wrong_hits_limit) {
            ++answer_.wrong;
            answer_.wrong_within_limits += keeps_to_limits(setting) ? 1 : 0;
            return;
        }
        settings_.push_back(std::move(setting));
    }

    double worst_value(const AdvisedSetting& setting, const FigureDeclaration& figure) const {
        const auto at = std::ranges::find(advice_.figures, &figure) - advice_.figures.begin();
        return *setting.figures[static_cast<std::size_t>(at)];
    }
    double rank(const AdvisedSetting& setting) const { return worst_value(setting, *request_.rank_by); }
    bool ranks_before(const AdvisedSetting& a, const AdvisedSetting& b) const {
        return is_better(rank(a), rank(b), request_.rank_by->better);
    }
    bool told_apart_by_error(const AdvisedSetting& a, const AdvisedSetting& b) const {
        return can_be_told_apart(rank(a), rank(b), tolerance_of(*request_.rank_by));
    }

    bool keeps_to(const AdvisedSetting& setting, const AdviceLimit& limit) const {
        return !is_better(limit.value, worst_value(setting, *limit.figure), limit.figure->better);
    }
    bool keeps_to_limits(const AdvisedSetting& setting) const {
        return std::ranges::all_of(request_.limits, [&](const AdviceLimit& limit) { return keeps_to(setting, limit); });
    }
    bool errors_are_limited() const {
        return std::ranges::any_of(request_.limits, [](const AdviceLimit& limit) { return is_error(*limit.figure); });
    }

    bool is_cheaper(const AdvisedSetting& a, const AdvisedSetting& b) const {
        if (a.ms != b.ms) return a.ms < b.ms;
        return rank(a) != rank(b) ? ranks_before(a, b) : a.setting < b.setting;
    }

    /// Where errors are limited the cheapest; else the cheapest of those whose error cannot be told from the least.
    const AdvisedSetting* best_of(const std::vector<const AdvisedSetting*>& kept) const {
        if (kept.empty()) return nullptr;
        const auto cheaper = [this](const AdvisedSetting* a, const AdvisedSetting* b) { return is_cheaper(*a, *b); };
        if (errors_are_limited()) return *std::ranges::min_element(kept, cheaper);
        const AdvisedSetting& most_exact = **std::ranges::min_element(
            kept, [this](const AdvisedSetting* a, const AdvisedSetting* b) { return ranks_before(*a, *b); });
        std::vector<const AdvisedSetting*> as_exact = kept;
        std::erase_if(as_exact,
                      [&](const AdvisedSetting* setting) { return told_apart_by_error(*setting, most_exact); });
        return *std::ranges::min_element(as_exact, cheaper);
    }

    void answer_not_told_apart(const std::vector<const AdvisedSetting*>& kept, const AdvisedSetting& best) {
        for (const AdvisedSetting* setting : kept) {
            const bool overlaps =
                setting->ci95_ms.low <= best.ci95_ms.high && best.ci95_ms.low <= setting->ci95_ms.high;
            if (setting == &best || !overlaps) continue;
            if (!errors_are_limited() && told_apart_by_error(*setting, best)) continue;
            answer_.not_told_apart.push_back(*setting);
        }
        std::ranges::sort(answer_.not_told_apart, [this](const AdvisedSetting& a, const AdvisedSetting& b) {
            return rank(a) != rank(b) ? ranks_before(a, b) : is_cheaper(a, b);
        });
    }

    /// By how many times the figure is beyond its limit; at most 1 within it.
    double excess(const AdvisedSetting& setting, const AdviceLimit& limit) const {
        const double value = worst_value(setting, *limit.figure);
        const bool lower = limit.figure->better == Better::lower;
        const double above = lower ? value : limit.value;
        const double below = lower ? limit.value : value;
        if (keeps_to(setting, limit)) return 1;
        return below > 0 ? above / below : std::numeric_limits<double>::infinity();
    }

    void answer_nearest() {
        const auto largest_excess = [this](const AdvisedSetting& setting) {
            double largest = 0;
            for (const AdviceLimit& limit : request_.limits) {
                largest = std::max(largest, excess(setting, limit));
            }
            return largest;
        };
        const auto nearest = std::ranges::min_element(settings_, [&](const AdvisedSetting& a, const AdvisedSetting& b) {
            const double first = largest_excess(a);
            const double second = largest_excess(b);
            return first != second ? first < second : is_cheaper(a, b);
        });
        if (nearest != settings_.end()) answer_.nearest = *nearest;
    }

    bool keeps_to_all_but(const AdviceLimit& left_out, const AdvisedSetting& setting) const {
        return std::ranges::all_of(
            request_.limits, [&](const AdviceLimit& limit) { return &limit == &left_out || keeps_to(setting, limit); });
    }

    /// Of what keeps to the other limits: from the least error within the budget on; where nothing is, from the
    /// nearest, or the cheapest.
    void answer_next_better() {
        const AdviceLimit& budget = *budget_of(request_);
        std::vector<const AdvisedSetting*> beyond;
        const AdvisedSetting* before = nullptr;
        for (const AdvisedSetting& setting : settings_) {
            if (!keeps_to_all_but(budget, setting)) continue;
            if (!keeps_to(setting, budget)) {
                beyond.push_back(&setting);
            } else if (before == nullptr || ranks_before(setting, *before)) {
                before = &setting;
            }
        }
        if (answer_.nearest && keeps_to_all_but(budget, *answer_.nearest)) before = &*answer_.nearest;
        std::ranges::sort(beyond,
                          [this](const AdvisedSetting* a, const AdvisedSetting* b) { return is_cheaper(*a, *b); });
        for (const AdvisedSetting* setting : beyond) {
            if (answer_.next_better.size() == next_steps) break;
            const bool better =
                before == nullptr || (ranks_before(*setting, *before) && told_apart_by_error(*setting, *before));
            if (!better) continue;
            answer_.next_better.push_back(*setting);
            before = setting;
        }
    }

    /// Of `settings`, those with more wrong hits than `max_wrong_hits` left out.
    void answer_preset(PresetAdvice& of, const std::vector<AdvisedSetting>& settings, double max_wrong_hits) const {
        const AdvisedSetting& preset = of.preset;
        const AdvisedSetting* better = nullptr;
        const AdvisedSetting* cheaper = nullptr;
        for (const AdvisedSetting& setting : settings) {
            if (setting.wrong_hits > max_wrong_hits) continue;
            const bool told_apart = told_apart_by_error(setting, preset);
            const bool is_better = told_apart && ranks_before(setting, preset);
            const bool is_slower =
                setting.ci95_ms.low > preset.ci95_ms.high || setting.ms > (1 + same_time_tolerance) * preset.ms;
            const bool is_faster = setting.ci95_ms.high < preset.ci95_ms.low;
            if (is_better && !is_slower && (better == nullptr || ranks_before(setting, *better))) better = &setting;
            if ((is_better || !told_apart) && is_faster && (cheaper == nullptr || is_cheaper(setting, *cheaper)))
                cheaper = &setting;
        }
        if (better != nullptr && !of.better) of.better = *better;
        if (cheaper != nullptr && !of.cheaper) of.cheaper = *cheaper;
    }

    void answer_presets() {
        for (PresetAdvice& each : answer_.presets) {
            answer_preset(each, without_preset_, wrong_hits_limit);
            // What is as cheap as a preset that is wrong at grazing angles often is so, too, only less.
            answer_preset(each, without_preset_, each.preset.wrong_hits);
        }
        const std::optional<AdvisedSetting>& centre = answer_.best ? answer_.best : answer_.nearest;
        if (!centre) return;
        std::ranges::stable_sort(answer_.presets, {}, [&](const PresetAdvice& each) {
            return std::abs(std::log(each.preset.ms / centre->ms));
        });
    }

    const Advice& advice_;
    const AdviceRequest& request_;
    /// With few enough missed and false hits.
    std::vector<AdvisedSetting> settings_;
    /// Whatever their hits.
    std::vector<AdvisedSetting> without_preset_;
    ViewAdvice answer_;
};

std::vector<const FigureDeclaration*> figures_shown(const AdviceRequest& request, RankingFlip flip) {
    std::vector<const FigureDeclaration*> figures;
    const auto add = [&](const FigureDeclaration& figure) {
        if (std::ranges::find(figures, &figure) == figures.end()) figures.push_back(&figure);
    };
    add(*request.rank_by);
    for (const AdviceLimit& limit : request.limits) {
        add(*limit.figure);
    }
    add(known_figure(chosen_figures::quality));
    add(known_figure(path_of(flip)));
    return figures;
}

}  // namespace

const AdviceLimit* budget_of(const AdviceRequest& request) {
    const auto budget = std::ranges::find_if(
        request.limits, [](const AdviceLimit& limit) { return limit.figure->path == chosen_figures::cost; });
    return budget == request.limits.end() ? nullptr : &*budget;
}

const FigureDeclaration& ranking_figure(const std::vector<CellResult>& cells) {
    return known_figure(path_of(ranking_flip(cells)));
}

Advice advise(const std::vector<CellResult>& cells, const AdviceRequest& request, const Json& record) {
    Advice advice{.request = request,
                  .figures = {},
                  .flip = ranking_flip(cells),
                  .truth_samples = truth_samples(record),
                  .caution = caution_of_truth(cells, record),
                  .views = {},
                  .all_views = {}};
    advice.figures = figures_shown(request, advice.flip);
    const auto require = [&](const FigureDeclaration& figure) {
        if (std::ranges::none_of(cells,
                                 [&](const CellResult& cell) { return is_measured(cell) && value_of(figure, cell); }))
            fail("no measured cell of the run has {}", figure.path);
    };
    require(*request.rank_by);
    for (const AdviceLimit& limit : request.limits) {
        require(*limit.figure);
    }
    for (const ViewGroup& group : groups_of_views(cells)) {
        advice.views.push_back(Adviser(advice, group).answer());
    }
    if (request.asks_for_all_views && advice.views.size() > 1)
        advice.all_views = Adviser(advice, group_of_all_views(cells)).answer();
    return advice;
}

}  // namespace reliefbench
