#pragma once

#include "measure/shared_inputs.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"
#include "technique/technique.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// A cell that is ready to be sampled, with everything known of it but the draw's time. Its result is failed where the
/// device ended loops, and when more than half of the pixels left their loop by the iteration cap.
struct PreparedCell {
    Renderer renderer;
    CellResult result;
    /// Pass times of the preparation, kept for samples.jsonl.
    Preparation preparation;
    /// What the probed draw showed; for pictures, dropped before sampling.
    Probe probe;
};

/// A cell made ready, or why it is skipped.
struct PreparedOrSkipped {
    std::optional<PreparedCell> cell;
    std::string skip_reason;
};

/// Preparations that could not be made, by the maps that they would have made (Renderer::maps_key): other cells of the
/// same maps and settings would wait for the same end. Of one run, whose limit is one.
class FailedPreparations {
public:
    struct Failure {
        /// Given up at the limit, which skips the cell; else it fails.
        bool given_up = false;
        std::string reason;
    };

    /// Null where it is not known to fail.
    const Failure* find(const std::string& maps) const;
    void add(const std::string& maps, Failure failure) { failures_.emplace(maps, std::move(failure)); }
    /// Those that workers of an earlier execution died on, too often to be tried again (store/crashes.hpp).
    void add_crashed(const std::map<std::string, std::vector<std::string>>& crashed);

private:
    std::map<std::string, Failure> failures_;
};

/// What a preparation that takes long needs besides the configuration.
struct LongPreparation {
    /// PreparationSettings::cache.
    std::filesystem::path map_cache = {};
    std::function<void(const PreparationProgress&)> on_progress = {};
    /// Of the run so far, and added to.
    FailedPreparations& failed;
    /// Told the maps that are being made, and nothing when they are.
    std::function<void(const std::string& maps)> on_maps = {};
    /// Told what is begun, in words ("compiling"). May be empty.
    std::function<void(const std::string& stage)> on_stage = {};
};

/// "preparing (search) 34 %, 21 s left".
std::string describe(const PreparationProgress& progress);

/// Identity of the cell; nothing measured.
CellResult blank_result(const Cell& cell);

/// Compiles, prepares (each pass timed several times) and probes the cell, and compares it with its view's truth.
/// Skipped is what the device does not support and what takes longer to prepare than the configuration allows.
/// Throws Error for what fails only this cell: an answer out of range, too. What failed before of the same maps is not
/// tried again.
PreparedOrSkipped prepare_cell(const gpu::Device& device, const Technique& technique, const Cell& cell,
                               SharedInputs& inputs, const Configuration& configuration,
                               const LongPreparation& long_preparation);

}  // namespace reliefbench
