#include "compare/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench {

namespace {

double two_sided_p(const RatioEstimate& estimate) {
    return std::min(1.0, 2 * std::min(estimate.p_slower, estimate.p_faster));
}

/// The highest p-value that Benjamini & Hochberg's procedure rejects, or a negative number when it rejects none.
double highest_rejected(std::vector<double> p_values, double false_discovery_rate) {
    std::sort(p_values.begin(), p_values.end());
    const auto count = static_cast<double>(p_values.size());
    for (std::size_t rank = p_values.size(); rank > 0; --rank) {
        const double p = p_values[rank - 1];
        if (p <= false_discovery_rate * static_cast<double>(rank) / count) return p;
    }
    return -1;
}

Verdict verdict_at(const RatioEstimate& estimate, double threshold, double level) {
    const double high = 1 + threshold;
    const double low = 1 / high;
    if (low < estimate.ci95.low && estimate.ci95.high < high) return Verdict::same;
    if (two_sided_p(estimate) <= level && estimate.p_unchanged <= highest_p_unchanged) {
        if (estimate.ci95.low > high) return Verdict::slower;
        if (estimate.ci95.high < low) return Verdict::faster;
    }
    return Verdict::undecided;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return "same";
        case Verdict::faster:
            return "faster";
        case Verdict::slower:
            return "slower";
        case Verdict::undecided:
            return "undecided";
    }
    return "";
}

std::vector<Verdict> decide(std::span<const RatioEstimate> estimates, double threshold, double false_discovery_rate) {
    std::vector<double> p_values;
    for (const RatioEstimate& estimate : estimates) {
        p_values.push_back(two_sided_p(estimate));
    }
    const double level = highest_rejected(std::move(p_values), false_discovery_rate);
    std::vector<Verdict> verdicts;
    for (const RatioEstimate& estimate : estimates) {
        verdicts.push_back(verdict_at(estimate, threshold, level));
    }
    return verdicts;
}

double level_of_verdicts(std::span<const Verdict> verdicts, double false_discovery_rate) {
    const auto decided = std::count_if(verdicts.begin(), verdicts.end(), [](Verdict verdict) {
        return verdict == Verdict::slower || verdict == Verdict::faster;
    });
    const auto cells = static_cast<double>(std::max<std::size_t>(verdicts.size(), 1));
    return false_discovery_rate * std::min(static_cast<double>(decided) + 1, cells) / cells;
}

bool is_settled(const RatioEstimate& estimate, double threshold, double level) {
    return verdict_at(estimate, threshold, level) != Verdict::undecided;
}

}  // namespace reliefbench
