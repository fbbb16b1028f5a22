#pragma once

#include "core/json.hpp"
#include "measure/shared_inputs.hpp"
#include "sweep/configuration.hpp"
#include "technique/technique.hpp"

#include <vector>

namespace reliefbench {

/// What a run is made from; refers to it all.
struct RunSubject {
    const Configuration& configuration;
    const TechniqueLibrary& library;
    const std::vector<Cell>& cells;
    const std::vector<HeightMapRecord>& height_maps;
    const gpu::Device& device;
    /// Times are made beside other processes that measure on the device (--share-device).
    bool shares_device = false;
};

/// The content of run.json, but for what only the command line knows: configuration as expanded, environment, device,
/// content hashes of the techniques, height maps and mesh files in use, the time of an empty pass, and the filter's
/// deviation for each height format in use.
Json make_run_record(const RunSubject& subject);

}  // namespace reliefbench
