#pragma once

#include "measure/clock.hpp"
#include "measure/subject.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace reliefbench {

/// Two variants of one cell.
struct SubjectPair {
    Subject* base = nullptr;
    Subject* changed = nullptr;
};

/// log(changed ms / base ms) of one pass, one value per round; of a visit's samples the median counts.
using LogRatios = std::vector<double>;

struct PairSampling {
    int samples_per_visit = 1;
    /// Wall time for all pairs together.
    double budget_s = 300;
    std::uint64_t seed = 1;
};

/// Called after each round that it asked for; true when the pair needs no more rounds.
using PairIsDecided = std::function<bool(std::size_t pair, const LogRatios& log_ratios)>;

/// Warms everything up, then visits all undecided pairs in rounds: pairs in random order, both sides of a pair one
/// directly after the other in random order, until every pair is decided or the budget is spent. A pair one side of
/// which throws Error is handed to `on_failure` and visited no more.
std::vector<LogRatios> sample_pairs(const std::vector<SubjectPair>& pairs, const PairSampling& sampling,
                                    const PairIsDecided& is_decided,
                                    const std::function<void(std::size_t, const std::string&)>& on_failure,
                                    const Clock& clock = steady_clock());

}  // namespace reliefbench
