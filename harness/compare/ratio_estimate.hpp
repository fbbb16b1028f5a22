#pragma once

#include "core/statistics.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace reliefbench {

/// The highest two-sided p-value of "nothing changed" beside which a verdict of slower or faster may stand, however
/// many cells agree. What moves all cells at once (another process, a warm machine) makes them wrong together, and then
/// correction for many cells does not help: this bounds the cells of unchanged code called wrongly at 1 in 1000 by
/// itself, which is what comparing promises.
constexpr double highest_p_unchanged = 0.001;

/// What is known of new time / base time. Ratios are multiplicative, so that a threshold of 2 % means above 1.02 or
/// below 1 / 1.02, and the estimates are made on logarithms.
struct RatioEstimate {
    double ratio = 1;
    /// Of the ratio, 95 %, not corrected for many cells. From 0 to infinity where the evidence is too little for any.
    Interval ci95{1, 1};
    /// One-sided p-values of "the new side is not slower (not faster) than by the threshold": small speaks against it.
    double p_slower = 1;
    double p_faster = 1;
    /// Two-sided p-value of "the ratio is 1".
    double p_unchanged = 1;
    /// The smallest change beyond which evidence as noisy and as much as this is decided as a rule (99 in 100), as a
    /// fraction: 0.05 is 5 %. It is at least the threshold; infinite where nothing could be seen.
    double visible = 0;
    /// Rounds, or runs a side, that the estimate rests on.
    std::size_t units = 0;
    /// How many more of them would decide if the ratio stays where it is; 0 when the interval decides already; empty
    /// when no reasonable number would (the ratio lies at the threshold).
    std::optional<std::size_t> more;
};

}  // namespace reliefbench
