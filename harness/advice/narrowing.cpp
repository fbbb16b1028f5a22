#include "advice/narrowing.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

namespace reliefbench {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
/// Rounds before a contender is judged by its bounds alone, and those of what is wanted whatever else is better.
constexpr std::size_t first_rounds = 3;
constexpr std::size_t wanted_rounds = 6;
/// Rounds that give a median a 95 % interval.
constexpr std::size_t rounds_of_interval = 6;
/// Rungs that are passed over where a ladder was not looked at yet: four times the sample count of neighbours at √2.
constexpr std::size_t coarse_rungs = 4;

/// To what is greater.
void raise(CellErrors& errors, const CellErrors& other) {
    errors.rank = std::max(errors.rank, other.rank);
    for (std::size_t at = 0; at < errors.limited.size(); ++at)
        errors.limited[at] = std::max(errors.limited[at], other.limited[at]);
}

}  // namespace

TimeBounds time_bounds(const PassTiming& draw, bool is_settled) {
    assert(draw.rounds > 0);
    constexpr double margin_of_one_round = 0.3;
    const double margin = draw.rounds < rounds_of_interval ? margin_of_one_round / static_cast<double>(draw.rounds) : 0;
    return {draw.ci95_ms.low * (1 - margin), draw.ci95_ms.high * (1 + margin), draw.median_ms, draw.rounds, is_settled};
}

Narrowing::Narrowing(std::vector<SweptSetting> settings, std::vector<Contest> contests, const AdviceRequest& request)
    : settings_(std::move(settings)), contests_(std::move(contests)), rules_(request) {
    for (std::size_t setting = 0; setting < settings_.size(); ++setting) {
        const std::size_t ladder = settings_[setting].ladder;
        if (ladders_.size() <= ladder) ladders_.resize(ladder + 1);
        ladders_[ladder].push_back(setting);
        for (std::size_t view = 0; view < settings_[setting].cells.size(); ++view) {
            const std::optional<std::size_t> cell = settings_[setting].cells[view];
            if (!cell) continue;
            if (places_.size() <= *cell) places_.resize(*cell + 1);
            places_[*cell] = Place{setting, view};
        }
    }
    seen_.resize(places_.size());
    for (std::vector<std::size_t>& ladder : ladders_) {
        std::ranges::sort(ladder, {}, [this](std::size_t setting) { return settings_[setting].sample_count; });
    }
}

void Narrowing::set_result(std::size_t cell, const CellResult& result) {
    Seen& seen = seen_.at(cell);
    seen.is_known = true;
    seen.is_skipped = result.status == CellStatus::skipped;
    seen.reason = result.reason;
    if (seen.is_skipped) return;
    seen.errors = rules_.errors_of(result);
    seen.is_failed = result.status == CellStatus::failed || !seen.errors;
}

void Narrowing::set_times(std::size_t cell, const TimeBounds& bounds) {
    seen_.at(cell).time = bounds;
}

const Narrowing::Seen& Narrowing::seen_of(std::size_t setting, std::size_t view) const {
    return seen_[*settings_[setting].cells[view]];
}

/// What an error may have fallen to beyond the two highest rungs that were looked at. Errors fall ever more slowly
/// along a ladder, so that the line through both, over the logarithm of the sample count, would lie below it; here it
/// falls twice as steeply, as errors may begin slowly while everything is wrong.
double Narrowing::rank_from_below(std::size_t setting, std::size_t view) const {
    constexpr double steeper = 2;
    const double bound = rules_.least_errors().rank;
    if (bound < 0) return bound;  // more is better, and grows as it likes
    const auto octave = [this](std::size_t rung) {
        return std::log2(static_cast<double>(std::max<std::int64_t>(1, settings_[rung].sample_count)));
    };
    std::vector<std::size_t> below;
    for (const std::size_t rung : ladders_[settings_[setting].ladder]) {
        if (settings_[rung].sample_count >= settings_[setting].sample_count) break;
        if (settings_[rung].cells[view] && seen_of(rung, view).errors) below.push_back(rung);
    }
    if (below.size() < 2) return bound;
    const std::size_t more = below.back();
    const std::size_t fewer = below[below.size() - 2];
    const double rank = seen_of(more, view).errors->rank;
    const double slope = std::max(0.0, seen_of(fewer, view).errors->rank - rank) / (octave(more) - octave(fewer));
    return std::max(bound, rank - steeper * slope * (octave(setting) - octave(more)));
}

/// Where a cell was not looked at, those of its ladder bound it: fewer samples take no longer, more err no more.
void Narrowing::add_view(std::size_t setting, std::size_t view, SettingBounds& bounds) const {
    const Seen& own = seen_of(setting, view);
    if (own.is_skipped || own.is_failed) {
        bounds.is_possible = false;
        return;
    }
    double time_low = own.time.rounds > 0 ? own.time.low_ms : 0;
    CellErrors errors = own.errors ? *own.errors : rules_.least_errors();
    if (!own.errors) errors.rank = rank_from_below(setting, view);
    for (const std::size_t other : ladders_[settings_[setting].ladder]) {
        if (other == setting || !settings_[other].cells[view]) continue;
        const Seen& seen = seen_of(other, view);
        // What the device or the map does not allow one sample count it allows none.
        if (seen.is_skipped) bounds.is_possible = false;
        const bool is_below = settings_[other].sample_count < settings_[setting].sample_count;
        if (is_below && own.time.rounds == 0 && seen.time.rounds > 0) time_low = std::max(time_low, seen.time.low_ms);
        if (!is_below && !own.errors && seen.errors) raise(errors, *seen.errors);
    }
    const bool is_timed = own.is_known && own.time.rounds > 0;
    bounds.is_complete = bounds.is_complete && is_timed;
    bounds.is_drawn_somewhere = bounds.is_drawn_somewhere || own.is_known;
    bounds.time_low = std::max(bounds.time_low, time_low);
    bounds.time_high = std::max(bounds.time_high, is_timed ? own.time.high_ms : endless);
    bounds.time = std::max(bounds.time, own.time.median_ms);
    raise(bounds.errors, errors);
}

SettingBounds Narrowing::bounds_of(std::size_t setting, const Contest& contest) const {
    SettingBounds bounds;
    bounds.errors = rules_.least_errors();
    for (const std::size_t view : contest) {
        if (!settings_[setting].cells[view]) {
            bounds.is_possible = false;
            return bounds;
        }
        add_view(setting, view, bounds);
    }
    return bounds;
}

/// By fewer samples of the same ladder, which take no longer, whatever noise makes of their times.
Narrowing::Dominance Narrowing::dominance(std::size_t setting, const Judged& judged) const {
    Dominance dominance;
    const SettingBounds& own = judged.bounds[setting];
    const std::optional<double>& least = judged.standing.least_rank;
    for (const std::size_t other : ladders_[settings_[setting].ladder]) {
        const SettingBounds& bounds = judged.bounds[other];
        const bool is_below = settings_[other].sample_count < settings_[setting].sample_count;
        if (!is_below || !bounds.is_possible || !bounds.is_complete || !rules_.may_keep_errors(bounds)) continue;
        const bool errs_no_more = bounds.errors.rank <= own.errors.rank;
        const bool is_as_good = least && !rules_.told_apart(bounds.errors.rank, own.errors.rank) &&
                                !rules_.told_apart(bounds.errors.rank, *least);
        dominance.as_best = dominance.as_best || rules_.are_errors_limited() || errs_no_more || is_as_good;
        dominance.as_next = dominance.as_next || errs_no_more;
    }
    return dominance;
}

Narrowing::Judged Narrowing::judge(const Contest& contest) const {
    Judged judged;
    for (std::size_t setting = 0; setting < settings_.size(); ++setting)
        judged.bounds.push_back(bounds_of(setting, contest));
    judged.standing = rules_.standing_of(judged.bounds);
    bool may_any_win = false;
    for (std::size_t setting = 0; setting < settings_.size(); ++setting) {
        const SettingBounds& bounds = judged.bounds[setting];
        const Dominance dominated = dominance(setting, judged);
        // What the figures so far advise is measured, though it may owe its place to noise.
        const bool is_advised = &bounds == judged.standing.best || &bounds == judged.standing.next;
        const bool wins = !dominated.as_best && rules_.may_win(bounds, judged.standing);
        may_any_win = may_any_win || wins || is_advised;
        judged.is_viable.push_back(is_advised || wins ||
                                   (!dominated.as_next && rules_.may_be_next(bounds, judged.standing)));
    }
    if (may_any_win) return judged;
    for (std::size_t setting = 0; setting < settings_.size(); ++setting) {
        const SettingBounds& bounds = judged.bounds[setting];
        const bool may_be_nearest =
            !judged.standing.has_nearest || rules_.least_excess(bounds) <= judged.standing.nearest_excess;
        if (bounds.is_possible && may_be_nearest) judged.is_viable[setting] = true;
    }
    return judged;
}

/// Where rungs are looked at on one side only a coarse step goes on; between two that were the middle one is next, of
/// the gap with the most samples, where errors are least.
std::optional<std::size_t> Narrowing::next_rung(const Judged& judged, const std::vector<std::size_t>& ladder) const {
    const auto is_open = [&](std::size_t rung) {
        return judged.is_viable[ladder[rung]] && !judged.bounds[ladder[rung]].is_drawn_somewhere;
    };
    std::vector<std::size_t> looked_at;
    for (std::size_t rung = 0; rung < ladder.size(); ++rung) {
        if (judged.bounds[ladder[rung]].is_drawn_somewhere) looked_at.push_back(rung);
    }
    if (looked_at.empty()) {
        std::optional<std::size_t> start;
        for (std::size_t rung = 0; rung < ladder.size(); ++rung) {
            const auto distance = [&](std::size_t of) { return settings_[ladder[of]].distance_from_start; };
            if (is_open(rung) && (!start || distance(rung) < distance(*start))) start = rung;
        }
        return start;
    }
    const std::size_t top = ladder.size() - 1;
    for (std::size_t rung = std::min(looked_at.back() + coarse_rungs, top); rung > looked_at.back(); --rung) {
        if (is_open(rung)) return rung;
    }
    for (std::size_t gap = looked_at.size(); gap-- > 1;) {
        std::vector<std::size_t> open;
        for (std::size_t rung = looked_at[gap - 1] + 1; rung < looked_at[gap]; ++rung) {
            if (is_open(rung)) open.push_back(rung);
        }
        if (!open.empty()) return open[open.size() / 2];
    }
    const std::size_t lowest = looked_at.front();
    for (std::size_t rung = lowest > coarse_rungs ? lowest - coarse_rungs : 0; rung < lowest; ++rung) {
        if (is_open(rung)) return rung;
    }
    return std::nullopt;
}

/// One rung that was not looked at, in the first of the contest's views, and all views of the most promising one that
/// was looked at in some.
std::vector<std::size_t> Narrowing::chosen_of_ladder(const Contest& contest, const Judged& judged,
                                                     const std::vector<std::size_t>& ladder) const {
    std::vector<std::size_t> chosen;
    std::optional<std::size_t> to_complete;
    const auto promise = [&](std::size_t setting) {
        const SettingBounds& bounds = judged.bounds[setting];
        return rules_.are_errors_limited() ? std::pair(bounds.time_low, bounds.errors.rank)
                                           : std::pair(bounds.errors.rank, bounds.time_low);
    };
    for (const std::size_t setting : ladder) {
        const SettingBounds& bounds = judged.bounds[setting];
        if (!judged.is_viable[setting] || bounds.is_complete || !bounds.is_drawn_somewhere) continue;
        if (!to_complete || promise(setting) < promise(*to_complete)) to_complete = setting;
    }
    if (to_complete) {
        for (const std::size_t view : contest)
            chosen.push_back(*settings_[*to_complete].cells[view]);
    }
    if (const std::optional<std::size_t> rung = next_rung(judged, ladder))
        chosen.push_back(*settings_[ladder[*rung]].cells[contest.front()]);
    return chosen;
}

bool Narrowing::may_be_visited(std::size_t cell) const {
    const Seen& seen = seen_[cell];
    return seen.is_known && !seen.is_failed && !seen.is_skipped;
}

/// Those that were drawn: the first rounds of each, then all that are complete together, until the last of them is
/// settled: what decides between them are rounds of the same minutes.
void Narrowing::visit_contenders(const Contest& contest, const Judged& judged, std::set<std::size_t>& visited) const {
    std::vector<std::size_t> together;
    for (std::size_t setting = 0; setting < settings_.size(); ++setting) {
        if (!judged.is_viable[setting]) continue;
        for (const std::size_t view : contest) {
            const std::size_t cell = *settings_[setting].cells[view];
            if (!may_be_visited(cell)) continue;
            if (seen_[cell].time.rounds < first_rounds) visited.insert(cell);
            if (judged.bounds[setting].is_complete) together.push_back(cell);
        }
    }
    const bool are_settled =
        std::ranges::all_of(together, [this](std::size_t cell) { return seen_[cell].time.is_settled; });
    if (!are_settled) visited.insert(together.begin(), together.end());
}

/// Of what is wanted whatever else is better: the first views of the contests, then the others.
std::set<std::size_t> Narrowing::unseen_wanted() const {
    std::set<std::size_t> first;
    std::set<std::size_t> all;
    for (const SweptSetting& setting : settings_) {
        if (!setting.is_wanted) continue;
        for (const Contest& contest : contests_) {
            const std::optional<std::size_t> cell = setting.cells[contest.front()];
            if (cell && !seen_[*cell].is_known) first.insert(*cell);
        }
        for (const std::optional<std::size_t>& cell : setting.cells) {
            if (cell && !seen_[*cell].is_known) all.insert(*cell);
        }
    }
    return first.empty() ? all : first;
}

std::vector<std::size_t> Narrowing::next_round() const {
    std::set<std::size_t> visited;
    std::set<std::size_t> unseen;
    std::set<std::size_t> unseen_with_maps;
    for (const Contest& contest : contests_) {
        const Judged judged = judge(contest);
        for (const std::vector<std::size_t>& ladder : ladders_) {
            for (const std::size_t cell : chosen_of_ladder(contest, judged, ladder)) {
                const SweptSetting& setting = settings_[places_[cell]->setting];
                if (!seen_[cell].is_known && !setting.is_wanted)
                    (setting.needs_maps ? unseen_with_maps : unseen).insert(cell);
            }
        }
        visit_contenders(contest, judged, visited);
    }
    // What bounds others is known well enough before they are looked at: a round takes less than a draw of another
    // cell.
    const auto is_hardly_known = [this](std::size_t cell) { return seen_[cell].time.rounds < first_rounds; };
    if (std::ranges::any_of(visited, is_hardly_known)) {
        std::erase_if(visited, std::not_fn(is_hardly_known));
        return {visited.begin(), visited.end()};
    }
    for (const SweptSetting& setting : settings_) {
        if (!setting.is_wanted) continue;
        for (const std::optional<std::size_t>& cell : setting.cells) {
            if (cell && may_be_visited(*cell) && seen_[*cell].time.rounds < wanted_rounds) visited.insert(*cell);
        }
    }
    // What may be long in coming, or decides nothing, comes when there is an answer.
    if (unseen.empty()) unseen = std::move(unseen_with_maps);
    if (unseen.empty()) unseen = unseen_wanted();
    visited.merge(unseen);
    return {visited.begin(), visited.end()};
}

std::size_t Narrowing::contenders() const {
    std::set<std::size_t> settings;
    for (const Contest& contest : contests_) {
        const Judged judged = judge(contest);
        for (std::size_t setting = 0; setting < settings_.size(); ++setting) {
            if (judged.is_viable[setting]) settings.insert(setting);
        }
    }
    return settings.size();
}

std::string Narrowing::reason_left_out(std::size_t cell) const {
    if (cell >= places_.size() || !places_[cell]) return "";
    const auto [setting, view] = *places_[cell];
    for (const std::size_t other : ladders_[settings_[setting].ladder]) {
        if (!settings_[other].cells[view]) continue;
        const Seen& seen = seen_of(other, view);
        if (seen.is_skipped) return seen.reason;
    }
    std::string reason;
    for (const Contest& contest : contests_) {
        if (std::ranges::find(contest, view) == contest.end()) continue;
        const SettingBounds bounds = bounds_of(setting, contest);
        if (judge(contest).is_viable[setting]) return "";
        if (!bounds.is_possible) {
            reason = "not measured: it is no answer in another view";
        } else if (bounds.time_low > rules_.budget_ms()) {
            reason = "not measured: with fewer samples, or in another view, it takes longer than the budget";
        } else if (!rules_.may_keep_errors(bounds)) {
            reason = "not measured: with more samples, or in another view, it errs more than may be";
        } else {
            reason = "not measured: others err no more and take no longer, as its other sample counts show";
        }
    }
    return reason;
}

}  // namespace reliefbench
