#pragma once

#include "advice/contest_rules.hpp"
#include "report/advice.hpp"
#include "store/cell_result.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace reliefbench {

/// Which cells of a sweep are worth measuring for an answer, decided while it is measured. Pure: it is told what was
/// seen of cells and says what is to be looked at next. Time grows and errors fall along a ladder of sample counts, so
/// that what was seen of some rungs bounds those between them; what cannot be the answer by these bounds is not drawn,
/// and what was drawn and cannot be it gets no more rounds. docs/advice.md has the rules.

/// A technique with parameters.
struct SweptSetting {
    std::string technique;
    /// Settings of one ladder differ in the sample count alone. One that stands for itself has a ladder of its own.
    std::size_t ladder = 0;
    std::int64_t sample_count = 0;
    /// How far along its ladder it stands from where a sweep begins: the least is looked at first.
    double distance_from_start = 0;
    /// Maps are made for it first, which may take long: its ladder begins when the others have been looked at.
    bool needs_maps = false;
    /// Of a preset that its users look for: measured whatever else is better, when the others have been looked at.
    bool is_wanted = false;
    /// By view: where the cell stands in the run. Empty: the configuration has no such cell.
    std::vector<std::optional<std::size_t>> cells = {};
};

/// Views that are answered for together, by their numbers.
using Contest = std::vector<std::size_t>;

/// What is known of a draw's time: bounds of the median, and the median so far.
struct TimeBounds {
    double low_ms = 0;
    double high_ms = 0;
    double median_ms = 0;
    std::size_t rounds = 0;
    /// More rounds would not tell more.
    bool is_settled = false;
};

/// From what the rounds of a cell gave. With too few for a 95 % interval the bounds lie outside of what was seen, by
/// 30 % of it after one round and less after more.
TimeBounds time_bounds(const PassTiming& draw, bool is_settled);

class Narrowing {
public:
    /// A setting takes part in a contest where it has a cell in each of its views.
    Narrowing(std::vector<SweptSetting> settings, std::vector<Contest> contests, const AdviceRequest& request);

    /// The cell was drawn and has its figures, or has ended as skipped or failed.
    void set_result(std::size_t cell, const CellResult& result);
    void set_times(std::size_t cell, const TimeBounds& bounds);

    /// The cells to visit once more, in ascending order; those that have no result yet are to be made ready first.
    /// Empty when nothing more is worth knowing.
    std::vector<std::size_t> next_round() const;

    /// Why a cell without a result was not worth measuring; empty while it may be.
    std::string reason_left_out(std::size_t cell) const;

    /// Settings that can still be an answer, or are one.
    std::size_t contenders() const;

private:
    struct Place {
        std::size_t setting = 0;
        std::size_t view = 0;
    };
    struct Seen {
        bool is_known = false;
        bool is_skipped = false;
        bool is_failed = false;
        /// Empty where it was not drawn, or has not all of them.
        std::optional<CellErrors> errors;
        std::string reason;
        TimeBounds time;
    };
    struct Judged {
        std::vector<SettingBounds> bounds;
        Standing standing;
        std::vector<bool> is_viable;
    };

    const Seen& seen_of(std::size_t setting, std::size_t view) const;
    void add_view(std::size_t setting, std::size_t view, SettingBounds& bounds) const;
    double rank_from_below(std::size_t setting, std::size_t view) const;
    SettingBounds bounds_of(std::size_t setting, const Contest& contest) const;
    Judged judge(const Contest& contest) const;
    struct Dominance {
        bool as_best = false;
        bool as_next = false;
    };
    Dominance dominance(std::size_t setting, const Judged& judged) const;

    std::set<std::size_t> unseen_wanted() const;
    bool may_be_visited(std::size_t cell) const;
    void visit_contenders(const Contest& contest, const Judged& judged, std::set<std::size_t>& visited) const;
    std::vector<std::size_t> chosen_of_ladder(const Contest& contest, const Judged& judged,
                                              const std::vector<std::size_t>& ladder) const;
    std::optional<std::size_t> next_rung(const Judged& judged, const std::vector<std::size_t>& ladder) const;

    std::vector<SweptSetting> settings_;
    std::vector<Contest> contests_;
    ContestRules rules_;
    /// By ladder, ascending in the sample count.
    std::vector<std::vector<std::size_t>> ladders_;
    /// By cell.
    std::vector<std::optional<Place>> places_;
    std::vector<Seen> seen_;
};

}  // namespace reliefbench
