#pragma once

#include "compare/comparison.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

/// A comparison in the words and the order that all its formats share.

struct ComparisonCounts {
    std::size_t slower = 0, faster = 0, same = 0, undecided = 0;
    std::size_t worse = 0, better = 0;
    std::size_t uncompared = 0, failed_now = 0;
};

ComparisonCounts count(const Comparison& comparison);

/// "75 cells compared: 2 slower, 1 faster, 60 same, 12 undecided; quality: 1 worse, 0 better; 3 not compared, ...".
std::string summary_line(const Comparison& comparison);

/// Of one verdict, the largest change first. Refers to the comparison.
std::vector<const CellComparison*> cells_with(const Comparison& comparison, Verdict verdict);
std::vector<const CellComparison*> cells_with(const Comparison& comparison, QualityVerdict verdict);
/// Of the same quality, but something else of what was drawn changed: taps, steps, memory, counts of pixels.
std::vector<const CellComparison*> cells_with_other_changes(const Comparison& comparison);

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

/// "error.uv_texels.p99 0.750 → 0.810"; "-" where a side has none.
std::string quality_change_text(const QualityChange& change);
/// The `limit` largest changes, those for the worse first, then those for the better; "and 3 more" at the end.
std::vector<std::string> quality_change_texts(const QualityComparison& quality, std::size_t limit);

}  // namespace reliefbench
