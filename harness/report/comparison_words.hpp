#pragma once

#include "compare/comparison.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// A comparison in the words and the order that all its formats share.

struct ComparisonCounts {
    std::size_t slower = 0, faster = 0, same = 0, undecided = 0;
    std::size_t worse = 0, mixed = 0, better = 0, same_quality = 0, not_comparable = 0;
    std::size_t uncompared = 0, failed_now = 0;
};

ComparisonCounts count(const Comparison& comparison);

/// "75 cells compared: 2 slower, 1 faster, 60 same, 12 undecided; quality: 1 worse, 0 mixed, 2 better, 72 same; 3 not
/// compared, ...".
std::string summary_line(const Comparison& comparison);

/// Of one verdict, the largest change first. Refers to the comparison. Of quality alone there is no verdict on times.
std::vector<const CellComparison*> cells_with(const Comparison& comparison, Verdict verdict);
std::vector<const CellComparison*> cells_with(const Comparison& comparison, QualityVerdict verdict);
/// Of a verdict that no figure decided, but something of what was drawn changed: by more than its tolerance, or a
/// deciding figure is known of one side only. With `any` however little.
std::vector<const CellComparison*> cells_with_other_changes(const Comparison& comparison, QualityVerdict verdict,
                                                            bool any = false);

/// Cells of one reason (MergedReason) together, those that failed now first.
struct UncomparedGroup {
    std::string reason;
    bool failed_now = false;
    std::vector<std::string> cells;
};
std::vector<UncomparedGroup> uncompared_by_reason(const Comparison& comparison);

std::string_view to_string(QualityVerdict verdict);

/// The change that a ratio is: "+7.2 %", "−6.5 %".
std::string change_text(double ratio);
/// "+5.1 to +9.4 %"; "-" where the evidence is too little for any.
std::string change_interval_text(const Interval& ratios);
/// Of a fraction: "3.1 %"; "-" for what is not finite.
std::string percent_text(double fraction);
/// "9", or "-" where no reasonable number would decide.
std::string more_text(const RatioEstimate& estimate);

/// What the reason adds to the verdict in words (describe); "" when nothing, or when it has words of its own.
std::string reason_beyond_figures(const CellComparison& cell, const Comparison& comparison);

/// "worse by 8.0 %: error.uv_texels.p99 0.750 → 0.810 texels"; "-" where a side has none.
std::string quality_change_text(const QualityChange& change);
/// The first `limit` of those beyond their tolerance, and of deciding figures that one side lacks; with no limit all.
/// "and 3 more" at the end counts the others.
std::vector<std::string> quality_change_texts(const QualityComparison& quality, std::optional<std::size_t> limit = {});

/// What a change of it has to exceed: "0.05 texels and 5 %".
std::string tolerance_text(const DecidingFigure& figure);
/// "error.uv_texels.p99, error.uv_texels.mean: 0.05 texels and 5 %; error.missed+error.false_hits: 0.1 % of footprint".
std::string deciding_figures_text(const std::vector<DecidingFigure>& figures);

}  // namespace reliefbench
