#pragma once

#include "store/run_folder.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// Hands over the lines of a run's samples.jsonl one by one: the file may be larger than memory. Values that are null
/// (not finite when measured) are left out, and so are lines of throttled rounds, in whose place the run took others.
/// Strict: a line that is cut short or holds no samples is an Error.
void read_samples(const std::filesystem::path& folder, const std::function<void(const RawSamples&)>& on_samples);

/// Of every cell, by its id: the median (ms) of each round in the order of the rounds.
using RoundMedians = std::map<std::string, std::vector<double>>;

RoundMedians read_round_medians(const std::filesystem::path& folder, const std::string& pass);

}  // namespace reliefbench
