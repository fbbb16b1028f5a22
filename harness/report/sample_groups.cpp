#include "report/sample_groups.hpp"

#include "core/statistics.hpp"
#include "store/read_samples.hpp"

#include <algorithm>
#include <cassert>
#include <system_error>

namespace reliefbench {

namespace {

SampleGroup summarize_group(int first_round, const std::vector<double>& ms) {
    constexpr std::array<double, 5> probabilities = {0, 0.25, 0.5, 0.75, 1};
    SampleGroup group;
    group.first_round = first_round;
    group.samples = ms.size();
    std::transform(probabilities.begin(), probabilities.end(), group.quantiles.begin(),
                   [&](double p) { return quantile(ms, p); });
    return group;
}

}  // namespace

RunSamples read_run_samples(const std::filesystem::path& folder) {
    RunSamples all;
    std::error_code ignored;
    if (!std::filesystem::exists(folder / samples_file, ignored)) return all;
    read_samples(folder, [&](const RawSamples& samples) {
        std::vector<double>& ms = all[samples.pass][samples.cell][samples.round];
        ms.insert(ms.end(), samples.ms.begin(), samples.ms.end());
    });
    return all;
}

std::vector<SampleGroup> group_samples(const SamplesByRound& rounds, std::size_t most) {
    assert(most > 0);
    const std::size_t rounds_per_group = (rounds.size() + most - 1) / most;
    std::vector<SampleGroup> groups;
    for (auto round = rounds.begin(); round != rounds.end();) {
        const int first_round = round->first;
        std::vector<double> ms;
        for (std::size_t taken = 0; taken < rounds_per_group && round != rounds.end(); ++taken, ++round) {
            ms.insert(ms.end(), round->second.begin(), round->second.end());
        }
        if (!ms.empty()) groups.push_back(summarize_group(first_round, ms));
    }
    return groups;
}

}  // namespace reliefbench
