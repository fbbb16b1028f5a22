#pragma once

#include "measure/clock.hpp"
#include "measure/subject.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace reliefbench {

/// Two variants of one cell.
struct SubjectPair {
    Subject* base = nullptr;
    Subject* changed = nullptr;
};

/// log(changed ms / base ms) of the draw, one value per round; of a visit's samples the lower quartile counts: what
/// disturbs a draw only ever makes it longer.
using LogRatios = std::vector<double>;

struct PairSampling {
    int samples_per_visit = 5;
    /// Wall time for all pairs together, warming up included. A round that has begun is finished.
    double budget_s = 300;
    std::uint64_t seed = 1;
};

/// Asked after each round; true when the pair needs no more of them.
using PairIsDecided = std::function<bool(std::size_t pair, const LogRatios& log_ratios)>;

/// One visit of both sides of a pair, as it was timed: milliseconds of one draw each.
struct PairVisit {
    std::size_t pair = 0;
    std::size_t round = 0;
    bool base_first = true;
    std::vector<double> base_ms;
    std::vector<double> changed_ms;
};

struct PairCallbacks {
    PairIsDecided is_decided;
    /// A side of the pair threw Error; it is visited no more.
    std::function<void(std::size_t pair, const std::string& reason)> on_failure;
    /// After each round, with the number of pairs that are still visited. May be empty.
    std::function<void(std::size_t undecided)> on_round;
    /// For keeping raw samples. May be empty.
    std::function<void(const PairVisit& visit)> on_visit;
};

/// Warms everything up, then visits all undecided pairs in rounds: pairs in random order, both sides of a pair one
/// directly after the other, until every pair is decided or failed or the budget is spent. Which side comes first is
/// random in every other round and the other way round in the next, so that neither side gains by its place.
std::vector<LogRatios> sample_pairs(const std::vector<SubjectPair>& pairs, const PairSampling& sampling,
                                    const PairCallbacks& callbacks, const Clock& clock = steady_clock());

}  // namespace reliefbench
