#pragma once

#include "core/statistics.hpp"
#include "report/ranking.hpp"
#include "store/figures.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// What to use, from the cells of a run: docs/report.md has the rules, which the report's page follows too.

/// A figure may be at most so much where lower is better, at least so much where higher is.
struct AdviceLimit {
    const FigureDeclaration* figure = nullptr;
    double value = 0;
};

struct AdviceRequest {
    /// All must be kept; on chosen_figures::cost it is the budget. Figures with a direction only.
    std::vector<AdviceLimit> limits;
    /// Ranks what keeps to them; with a direction, of error, image or motion.
    const FigureDeclaration* rank_by = nullptr;
    /// Whether to answer for all kinds of view together, too, as whoever chooses a setting once for all of them asks.
    bool asks_for_all_views = false;
};

/// A technique with parameters, by its worst view of a group.
struct AdvisedSetting {
    std::string setting;
    std::string technique;
    /// Empty without one.
    std::string preset;
    /// What selects it in a configuration, an entry of "techniques".
    Json selection;
    double ms = 0;
    /// Of that view's time.
    Interval ci95_ms;
    /// Per covered pixel.
    std::optional<double> ns_per_pixel;
    /// Covered pixels over all pixels of the picture: least and greatest of the views.
    std::optional<Interval> relief_share;
    double wrong_hits = 0;
    /// One for each of Advice::figures.
    std::vector<std::optional<double>> figures;
};

/// What a preset gives, and what would be had for its price: settings of no preset, whose missed and false hits are few
/// (wrong_hits_limit); where none of those is, no more than the preset's. Slower and faster are by the 95 % intervals;
/// what takes over 5 % longer by its median is slower, too.
struct PresetAdvice {
    AdvisedSetting preset;
    /// Not slower, with an error that can be told to be less: the one of the least error.
    std::optional<AdvisedSetting> better;
    /// Faster, with an error that cannot be told to be more: the fastest.
    std::optional<AdvisedSetting> cheaper;
};

/// The answer for one kind of view.
struct ViewAdvice {
    /// The axes by which this kind differs from the others of the run: "view_angle" and 60.
    std::vector<std::pair<std::string, Json>> axes;
    /// By the views' part of their ids.
    std::vector<std::string> views;
    /// Settings measured in all of the views, and those that were not.
    std::size_t settings = 0, incomplete = 0;
    /// Of the former, those with too many missed and false hits; and how many of these keep to all limits.
    std::size_t wrong = 0, wrong_within_limits = 0;

    std::optional<AdvisedSetting> best;
    /// The best of another technique.
    std::optional<AdvisedSetting> other_technique;
    /// Within the limits, too, and not to be told from the best: by time, and where that is by error the least error.
    std::vector<AdvisedSetting> not_told_apart;
    /// Where nothing keeps to all limits: what comes nearest.
    std::optional<AdvisedSetting> nearest;
    /// Beyond the budget, keeping to the other limits: by ascending time, each better than what came before.
    std::vector<AdvisedSetting> next_better;
    /// Measured in all of the views, those with too many missed and false hits too: by how near their cost is to the
    /// best's (by ratio), or to the nearest's.
    std::vector<PresetAdvice> presets;
};

struct Advice {
    AdviceRequest request;
    /// Shown of each setting: the ranking one first, the limited ones, UV error and FLIP.
    std::vector<const FigureDeclaration*> figures;
    RankingFlip flip = RankingFlip::footprint;
    /// A pixel of the pictures that FLIP is against.
    int truth_samples = 1;
    /// caution_of_truth
    std::string caution;
    std::vector<ViewAdvice> views;
    /// For all kinds of view together, where that was asked and there are several: without axes.
    std::optional<ViewAdvice> all_views;
};

/// The FLIP that ranks these cells.
const FigureDeclaration& ranking_figure(const std::vector<CellResult>& cells);

/// The limit on the draw's time; null where there is none.
const AdviceLimit* budget_of(const AdviceRequest& request);

/// Of the measured cells; `record` is run.json's. A figure of the request that none of them has is an Error.
Advice advise(const std::vector<CellResult>& cells, const AdviceRequest& request, const Json& record = Json());

}  // namespace reliefbench
