#pragma once

#include "compare/deciding_figures.hpp"
#include "report/advice.hpp"
#include "store/cell_result.hpp"

#include <optional>
#include <vector>

namespace reliefbench {

/// Of a cell, as far as advice asks for them; less is better everywhere.
struct CellErrors {
    double rank = 0;
    /// The limited ones, then missed and false hits.
    std::vector<double> limited;
};

/// What is known of a setting in the views that it is answered for: of times and errors what they are at least, unless
/// it is complete, when errors are what they are.
struct SettingBounds {
    /// False where it has a cell that is skipped or failed.
    bool is_possible = true;
    /// All of its cells are drawn and timed.
    bool is_complete = true;
    bool is_drawn_somewhere = false;
    double time_low = 0;
    double time_high = 0;
    /// Of the medians so far.
    double time = 0;
    CellErrors errors;
};

/// The best that are known; they refer to the bounds that they were found in.
struct Standing {
    const SettingBounds* best = nullptr;
    /// Within all limits.
    std::optional<double> least_rank;
    /// Beyond the budget.
    const SettingBounds* next = nullptr;
    double nearest_excess = 0;
    bool has_nearest = false;
};

/// The rules of advice (report/advice.hpp) for what is known by its bounds alone: what may still be an answer.
class ContestRules {
public:
    explicit ContestRules(const AdviceRequest& request);

    double budget_ms() const { return budget_ms_; }
    bool are_errors_limited() const { return are_errors_limited_; }
    /// Empty where the cell has not all figures that are asked for: it is no answer.
    std::optional<CellErrors> errors_of(const CellResult& result) const;
    /// Figures of which less is better are errors, and none is below 0.
    CellErrors least_errors() const;

    bool told_apart(double rank, double other) const;
    bool may_keep_errors(const SettingBounds& bounds) const;
    double least_excess(const SettingBounds& bounds) const;
    Standing standing_of(const std::vector<SettingBounds>& bounds) const;
    bool may_win(const SettingBounds& bounds, const Standing& standing) const;
    bool may_be_next(const SettingBounds& bounds, const Standing& standing) const;

private:
    const FigureDeclaration* rank_by_;
    FigureTolerance tolerance_;
    double budget_ms_;
    std::vector<const FigureDeclaration*> limited_;
    /// As values of which less is better; that of wrong hits last.
    std::vector<double> limits_;
    bool are_errors_limited_ = false;
};

}  // namespace reliefbench
