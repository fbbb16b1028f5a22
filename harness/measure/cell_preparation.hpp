#pragma once

#include "measure/shared_inputs.hpp"
#include "store/cell_result.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"
#include "technique/technique.hpp"

namespace reliefbench {

/// A cell that is ready to be sampled, with everything known of it but the draw's time.
struct PreparedCell {
    Renderer renderer;
    CellResult result;
    /// Pass times of the preparation, kept for samples.jsonl.
    Preparation preparation;
    /// What the probed draw showed; for pictures, dropped before sampling.
    Probe probe;
};

/// Identity of the cell; nothing measured.
CellResult blank_result(const Cell& cell);

/// Compiles, prepares (each pass timed several times) and probes the cell, and compares it with its view's truth.
/// Throws Error for what fails only this cell. The device must support it (unsupported_reason).
PreparedCell prepare_cell(const gpu::Device& device, const Technique& technique, const Cell& cell, SharedInputs& inputs,
                          const Configuration& configuration);

}  // namespace reliefbench
