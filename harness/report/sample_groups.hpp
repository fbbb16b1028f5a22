#pragma once

#include "store/run_folder.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// Samples (ms) of one cell's pass by round, in the order of the file.
using SamplesByRound = std::map<int, std::vector<double>>;
/// By pass, then by cell.
using RunSamples = std::map<std::string, std::map<std::string, SamplesByRound>>;

/// Of a run's folder; empty where it has no samples.jsonl.
RunSamples read_run_samples(const std::filesystem::path& folder);

/// The samples of consecutive rounds of one cell's pass.
struct SampleGroup {
    int first_round = 0;
    /// How many.
    std::size_t samples = 0;
    /// Minimum, quartiles and maximum, ms.
    std::array<double, 5> quantiles{};
};

/// At most `most` groups of equally many rounds each (the last may hold fewer), in the order of the rounds.
std::vector<SampleGroup> group_samples(const SamplesByRound& rounds, std::size_t most);

}  // namespace reliefbench
