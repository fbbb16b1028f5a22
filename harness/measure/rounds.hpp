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
    std::map<std::string, std::vector<double>> samples;
};

/// Warms every subject up, then visits all unsettled ones in rounds, each round in a new random order (seeded), until
/// `rule` calls every one settled. A subject that throws Error is handed to `on_failure` and visited no more.
std::vector<SampleRounds> sample_in_rounds(const std::vector<Subject*>& subjects, const StoppingRule& rule,
                                           int samples_per_visit, std::uint64_t seed,
                                           const std::function<void(const Visit&)>& on_visit,
                                           const std::function<void(std::size_t, const std::string&)>& on_failure);

}  // namespace reliefbench
