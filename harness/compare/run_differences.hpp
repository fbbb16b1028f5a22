#pragma once

#include "compare/stored_run.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Why the times of two runs say nothing of each other: another device, or for a CPU device another CPU. Empty when
/// there is no reason.
std::string device_difference(const StoredRun& base, const StoredRun& changed);

/// What else differs between the records of two runs, in words: driver, tool, sources of the techniques that both have,
/// sampling, truth, lighting, CPU, operating system.
std::vector<std::string> run_differences(const StoredRun& base, const StoredRun& changed);

/// Made with changes that no commit has.
bool from_changed_tree(const StoredRun& run);
bool same_truth(const StoredRun& base, const StoredRun& changed);
bool same_lighting(const StoredRun& base, const StoredRun& changed);
/// Cameras move alike, whatever becomes of the frames.
bool same_motion(const StoredRun& base, const StoredRun& changed);
/// The history that is carried along is blended alike.
bool same_history(const StoredRun& base, const StoredRun& changed);
/// What is compiled of the technique's own folder is the same on both sides, as far as the records prove it.
bool same_source(const StoredRun& base, const StoredRun& changed, const std::string& technique);

/// The technique's cells run the same code on the same machine on both sides, as far as the records prove it: the same
/// source and shared shaders (run.json `shaders`; in records without it the same git revision, nothing uncommitted),
/// driver, CPU and operating system. What differs then is the state of the machine.
bool same_code(const StoredRun& base, const StoredRun& changed, const std::string& technique);

/// Why two results of one cell id are of different subjects: parameters (a default changed), axes, or the content of
/// the height map or its albedo. Empty when they are not.
std::string subject_difference(const StoredRun& base, const CellResult& base_cell, const StoredRun& changed,
                               const CellResult& changed_cell);

}  // namespace reliefbench
