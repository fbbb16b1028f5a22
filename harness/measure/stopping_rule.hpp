#pragma once

#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace reliefbench {

/// The samples of one cell so far: by pass, by round.
using SampleRounds = std::map<std::string, std::vector<std::vector<double>>>;

/// Decides when a cell has been sampled enough; chosen in the configuration. Statistics stay out of the runner.
class StoppingRule {
public:
    virtual ~StoppingRule() = default;

    /// Why the cell needs no more rounds; empty while it does. `device_s` is the device's time in all of its samples so
    /// far. Asked after every round, in order.
    virtual std::optional<StopReason> stop(const SampleRounds& samples, double device_s) const = 0;
};

/// The rule and numbers that the configuration asks for.
std::unique_ptr<StoppingRule> make_stopping_rule(const SamplingSettings& settings);

/// After a fixed number of rounds.
std::unique_ptr<StoppingRule> make_fixed_rule(int rounds);

/// When the device has been at it for so long.
std::unique_ptr<StoppingRule> make_time_rule(double budget_s);

/// Not before `min_rounds`; then when, for every pass, the 95 % interval of the median of the rounds' medians lies
/// within ±`precision` of that median (precise), or more rounds do not narrow it (stalled), or `budget_s` of the
/// device's time is spent (budget, which ends it before `min_rounds` too, but not before the interval exists). The
/// interval is looked at after every round up to 32, then 16 times in every doubling of rounds.
std::unique_ptr<StoppingRule> make_precision_rule(double precision, int min_rounds, double budget_s);

/// The median of each round.
std::vector<double> round_medians(const std::vector<std::vector<double>>& rounds);

/// Whether more rounds would not narrow the 95 % interval of the median of a series of rounds' medians. The widths of
/// independent rounds fall as 1/√n: to 0.71 with every doubling. Judged where n is a power of two, at least 32: each of
/// the last two doublings has left at least 0.9 of the width. One doubling alone says little, for widths are noisy.
bool has_stopped_narrowing(std::span<const double> medians);

}  // namespace reliefbench
