#include "cli/variant_comparison.hpp"

#include "compare/describe.hpp"
#include "compare/look_schedule.hpp"
#include "compare/paired_rounds.hpp"
#include "compare/quality.hpp"
#include "compare/verdict.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// What the next look may spend is spent by one that comes before it, when the budget ends.
double level_of_last_look(std::size_t rounds) {
    return level_of_look(is_look(rounds) ? rounds : next_look(rounds));
}

std::vector<RatioEstimate> estimate_all(const VariantOutcome& outcome, double threshold, double level) {
    std::vector<RatioEstimate> estimates;
    for (const MeasuredPair& pair : outcome.measured) {
        estimates.push_back(
            estimate_paired(pair.log_ratios, threshold, level_of_last_look(pair.log_ratios.size()), level));
    }
    return estimates;
}

}  // namespace

CellIsDecided decided_at_looks(double threshold, std::size_t cells) {
    const double level = live_false_discovery_rate / static_cast<double>(std::max<std::size_t>(cells, 1));
    return [threshold, level](const LogRatios& log_ratios) {
        const std::size_t rounds = log_ratios.size();
        return is_look(rounds) &&
               is_settled(estimate_paired(log_ratios, threshold, level_of_look(rounds), level), threshold, level);
    };
}

Comparison compare_variants(const VariantOutcome& outcome, double threshold,
                            const std::vector<DecidingFigure>& deciding) {
    Comparison comparison;
    comparison.deciding_figures = deciding;
    comparison.threshold = threshold;
    comparison.unit = "rounds";
    const std::vector<Verdict> verdicts =
        decide(estimate_all(outcome, threshold, live_false_discovery_rate), threshold, live_false_discovery_rate);
    const std::vector<RatioEstimate> estimates =
        estimate_all(outcome, threshold, level_of_verdicts(verdicts, live_false_discovery_rate));
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const MeasuredPair& pair = outcome.measured[i];
        CellComparison cell;
        cell.cell = pair.changed.cell;
        cell.time = estimates[i];
        cell.verdict = verdicts[i];
        cell.quality = compare_quality(pair.base, pair.changed, deciding);
        cell.reason = describe(estimates[i], verdicts[i], comparison.unit);
        comparison.cells.push_back(std::move(cell));
    }
    for (const UnmeasuredPair& pair : outcome.unmeasured) {
        comparison.uncompared.push_back({pair.cell, pair.reason, pair.failed_now});
    }
    return comparison;
}

}  // namespace reliefbench
