#pragma once

#include "gpu/device.hpp"
#include "measure/cell_preparation.hpp"
#include "measure/pictures.hpp"
#include "measure/shared_inputs.hpp"
#include "metrics/hit_errors.hpp"
#include "metrics/image_errors.hpp"
#include "metrics/shadow_errors.hpp"
#include "technique/technique.hpp"

#include <optional>
#include <string>

namespace reliefbench {

/// Draws cells outside runs: once each, untimed.
class CellDrawing {
public:
    /// Device and library must outlive it. `preparation`: of each cell's maps.
    CellDrawing(const gpu::Device& device, const TechniqueLibrary& library, PreparationSettings preparation,
                const Lighting& lighting = {}, const std::optional<SceneObject>& object = std::nullopt);

    const Manifest& manifest_of(const Cell& cell) const { return library_->get(cell.technique).manifest; }
    /// An Error when the device does not support the cell, its preparation would take longer than its limit, or a
    /// shader does not compile.
    Probe probe(const Cell& cell);
    /// The parts are those of `probe` and of this object; its truth is valid until another view is drawn.
    DrawnCell beside_truth(const Cell& cell, const Probe& probe);
    /// Empty where the cell has no self-shadowing.
    std::optional<ShadowErrors> shadow_errors(const Cell& cell, const DrawnCell& drawn) const;

private:
    const gpu::Device* device_;
    const TechniqueLibrary* library_;
    PreparationSettings preparation_;
    Lighting lighting_;
    std::optional<SceneObject> object_;
    SharedInputs inputs_;
    FailedPreparations failed_preparations_;
};

HitErrors hit_errors_of(const DrawnCell& drawn);
ImageComparison image_errors_of(const DrawnCell& drawn);
/// Why `run` would call the cell failed, though it was drawn; empty where it would not.
std::string failure_of(const Probe& probe);

}  // namespace reliefbench
