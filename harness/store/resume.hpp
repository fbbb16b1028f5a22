#pragma once

#include "core/json.hpp"
#include "store/run_folder.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <unordered_set>
#include <vector>

namespace reliefbench {

/// What an interrupted run has already, to go on from.
struct EarlierWork {
    /// Cells, by id.
    std::unordered_set<std::string> finished;
    /// Visits that count of cells that are not finished, in the order of their rounds; of the passes of a visit, not of
    /// the preparation's.
    std::map<std::string, std::vector<RawSamples>> visits;
    /// What ended the workers that were on a cell, by cell.
    std::map<std::string, std::vector<std::string>> crashes;
    /// What ended the workers that were making derived maps, by the maps.
    std::map<std::string, std::vector<std::string>> crashed_preparations;
    /// The environment is not the one that the run began in, and was told to go on all the same: cells are marked.
    bool forced = false;
};

/// Strict, as read_run and read_samples are.
EarlierWork read_earlier_work(const std::filesystem::path& folder, const std::string& visited_pass);

/// Why a run that has `recorded` as its run.json must not be resumed by one that would write `now`, in words: the
/// configuration, the content of height maps, the sources of techniques or shared shaders, the device or its driver,
/// the tool's version, or for a CPU device the CPU differ. Where files lie does not matter, only what they hold.
std::vector<std::string> resume_differences(const Json& recorded, const Json& now);

}  // namespace reliefbench
