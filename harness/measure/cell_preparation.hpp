#pragma once

#include "measure/shared_inputs.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"
#include "technique/technique.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

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

/// What a preparation that takes long needs besides the configuration.
struct LongPreparation {
    /// PreparationSettings::cache.
    std::filesystem::path map_cache = {};
    std::function<void(const PreparationProgress&)> on_progress = {};
};

/// "preparing (search) 34 %, 21 s left".
std::string describe(const PreparationProgress& progress);

/// Identity of the cell; nothing measured.
CellResult blank_result(const Cell& cell);

/// Compiles, prepares (each pass timed several times) and probes the cell, and compares it with its view's truth.
/// Skipped is what the device does not support and what takes longer to prepare than the configuration allows.
/// Throws Error for what fails only this cell.
PreparedOrSkipped prepare_cell(const gpu::Device& device, const Technique& technique, const Cell& cell,
                               SharedInputs& inputs, const Configuration& configuration,
                               const LongPreparation& long_preparation);

}  // namespace reliefbench
