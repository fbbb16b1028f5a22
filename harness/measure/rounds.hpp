#pragma once

#include "measure/stopping_rule.hpp"
#include "measure/subject.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace reliefbench {

/// One visit, as it is told to the caller at once so that raw samples are kept even when the run ends abruptly.
struct Visit {
    std::size_t subject = 0;
    int round = 0;
    /// Position within the round.
    int order = 0;
    Subject::Samples samples;
    /// The device was throttled at its end.
    bool throttled = false;
    /// False for a throttled visit that another one replaces.
    bool counted = true;
};

/// A cell is visited at most so many times more than its rule asks for because the device was throttled; from then on
/// throttled visits count.
inline constexpr std::size_t max_throttled_repeats = 10;

/// What an interrupted execution has of a subject.
struct EarlierSamples {
    SampleRounds samples;
    /// The device's time in them.
    double device_s = 0;
};

struct RoundSampling {
    int samples_per_visit = 1;
    std::uint64_t seed = 1;
    /// Visits that the device may have at once: with two it goes on while the host reads and writes the one before.
    /// Where the host's work would take processors away from the device, one.
    std::size_t in_flight = 1;
    /// By subject; empty where nothing was sampled before.
    std::vector<EarlierSamples> earlier = {};
    /// The number of the first round: earlier samples have those before.
    int first_round = 0;
};

/// What the sampler asks and tells; all but the first two may be empty.
struct RoundCallbacks {
    std::function<void(const Visit&)> on_visit;
    /// The subject is visited no more.
    std::function<void(std::size_t subject, const std::string& reason)> on_failure;
    /// The subject is warmed up, submitted or collected now.
    std::function<void(std::size_t subject)> on_turn;
    /// Once, when all are warm: the timing phase begins.
    std::function<void()> on_warm;
    /// After every round.
    std::function<void(int round)> on_round;
    std::function<void(std::size_t subject, StopReason reason)> on_stop;
    /// Whether the device is throttled right now; asked at the end of every visit.
    std::function<bool()> is_throttled;
    /// Whether to end early; asked before every visit. Visits that the device has already are finished.
    std::function<bool()> is_interrupted;
};

struct SampledSubject {
    /// What counts.
    SampleRounds samples;
    /// Empty: the subject failed, or sampling was interrupted before it was done.
    std::optional<StopReason> stop;
    /// Of the rounds that count.
    std::size_t throttled_rounds = 0;
};

/// Warms every subject up, then visits all unsettled ones in rounds, each round in a new random order (seeded), until
/// `rule` stops every one. A subject that throws Error fails and is visited no more. Samples of a throttled visit are
/// told but do not count: the subject is visited in one round more.
std::vector<SampledSubject> sample_in_rounds(const std::vector<Subject*>& subjects, const StoppingRule& rule,
                                             const RoundSampling& sampling, const RoundCallbacks& callbacks);

}  // namespace reliefbench
