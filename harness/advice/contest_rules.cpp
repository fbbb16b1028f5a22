#include "advice/contest_rules.hpp"

#include "store/chosen_figures.hpp"

#include <algorithm>
#include <limits>

namespace reliefbench {

namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();
/// A first step beyond the budget is looked for up to this many times of it.
constexpr double next_step_window = 4;

/// As a value of which less is better.
double as_cost(double value, Better better) {
    return better == Better::higher ? -value : value;
}

}  // namespace

ContestRules::ContestRules(const AdviceRequest& request)
    : rank_by_(request.rank_by), tolerance_(tolerance_of(*request.rank_by)), budget_ms_(no_bound) {
    for (const AdviceLimit& limit : request.limits) {
        if (limit.figure->path == chosen_figures::cost) {
            budget_ms_ = std::min(budget_ms_, limit.value);
            continue;
        }
        limited_.push_back(limit.figure);
        limits_.push_back(as_cost(limit.value, limit.figure->better));
    }
    are_errors_limited_ = !limited_.empty();
    limits_.push_back(wrong_hits_limit);
}

std::optional<CellErrors> ContestRules::errors_of(const CellResult& result) const {
    const std::optional<double> rank = value_of(*rank_by_, result);
    const std::optional<double> wrong = wrong_hits(result);
    if (!rank || !wrong) return std::nullopt;
    CellErrors errors{.rank = as_cost(*rank, rank_by_->better), .limited = {}};
    for (const FigureDeclaration* figure : limited_) {
        const std::optional<double> value = value_of(*figure, result);
        if (!value) return std::nullopt;
        errors.limited.push_back(as_cost(*value, figure->better));
    }
    errors.limited.push_back(*wrong);
    return errors;
}

CellErrors ContestRules::least_errors() const {
    CellErrors least{.rank = rank_by_->better == Better::higher ? -no_bound : 0, .limited = {}};
    for (const FigureDeclaration* figure : limited_)
        least.limited.push_back(figure->better == Better::higher ? -no_bound : 0);
    least.limited.push_back(0);
    return least;
}

bool ContestRules::told_apart(double rank, double other) const {
    return size_in_tolerances(rank, other, tolerance_) > 1;
}

bool ContestRules::may_keep_errors(const SettingBounds& bounds) const {
    for (std::size_t at = 0; at < limits_.size(); ++at) {
        if (bounds.errors.limited[at] > limits_[at]) return false;
    }
    return true;
}

/// By how many times it is beyond its limits at least, wrong hits aside, which make it no answer at all.
double ContestRules::least_excess(const SettingBounds& bounds) const {
    if (bounds.errors.limited.back() > wrong_hits_limit) return no_bound;
    double excess = budget_ms_ < no_bound ? bounds.time_low / budget_ms_ : 0;
    for (std::size_t at = 0; at < limited_.size(); ++at) {
        const double limit = limits_[at];
        if (bounds.errors.limited[at] <= limit) continue;
        excess = std::max(excess, limit > 0 ? bounds.errors.limited[at] / limit : no_bound);
    }
    return excess;
}

Standing ContestRules::standing_of(const std::vector<SettingBounds>& bounds) const {
    Standing standing;
    std::vector<const SettingBounds*> keeping;
    std::vector<const SettingBounds*> beyond;
    for (const SettingBounds& each : bounds) {
        if (!each.is_possible || !each.is_complete) continue;
        const double excess = least_excess(each);
        if (!standing.has_nearest || excess < standing.nearest_excess) standing.nearest_excess = excess;
        standing.has_nearest = true;
        if (may_keep_errors(each)) (each.time <= budget_ms_ ? keeping : beyond).push_back(&each);
    }
    for (const SettingBounds* each : keeping)
        standing.least_rank = std::min(standing.least_rank.value_or(no_bound), each->errors.rank);
    for (const SettingBounds* each : keeping) {
        if (!are_errors_limited_ && told_apart(each->errors.rank, *standing.least_rank)) continue;
        if (standing.best == nullptr || each->time < standing.best->time) standing.best = each;
    }
    for (const SettingBounds* each : beyond) {
        if (standing.least_rank &&
            (each->errors.rank > *standing.least_rank || !told_apart(each->errors.rank, *standing.least_rank)))
            continue;
        if (standing.next == nullptr || each->time < standing.next->time) standing.next = each;
    }
    return standing;
}

bool ContestRules::may_win(const SettingBounds& bounds, const Standing& standing) const {
    if (!bounds.is_possible || bounds.time_low > budget_ms_ || !may_keep_errors(bounds)) return false;
    if (standing.best == nullptr || &bounds == standing.best) return true;
    if (!are_errors_limited_ && bounds.errors.rank > *standing.least_rank &&
        told_apart(bounds.errors.rank, *standing.least_rank))
        return false;
    if (!are_errors_limited_ && bounds.errors.rank < *standing.least_rank &&
        told_apart(bounds.errors.rank, *standing.least_rank))
        return true;
    return bounds.time_low < standing.best->time;
}

bool ContestRules::may_be_next(const SettingBounds& bounds, const Standing& standing) const {
    if (budget_ms_ == no_bound || !bounds.is_possible || bounds.time_high <= budget_ms_ || !may_keep_errors(bounds))
        return false;
    if (&bounds == standing.next) return true;
    if (standing.least_rank &&
        (bounds.errors.rank > *standing.least_rank || !told_apart(bounds.errors.rank, *standing.least_rank)))
        return false;
    return bounds.time_low < (standing.next != nullptr ? standing.next->time : next_step_window * budget_ms_);
}

}  // namespace reliefbench
