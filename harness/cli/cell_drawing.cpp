#include "cli/cell_drawing.hpp"

#include "core/error.hpp"
#include "core/log.hpp"
#include "technique/cut_loops.hpp"

#include <utility>

namespace reliefbench {

CellDrawing::CellDrawing(const gpu::Device& device, const TechniqueLibrary& library, PreparationSettings preparation,
                         const Lighting& lighting, const std::optional<SceneObject>& object)
    : device_(&device),
      library_(&library),
      preparation_(std::move(preparation)),
      lighting_(lighting),
      object_(object),
      inputs_(device, lighting, TruthSettings{}, object) {}

Probe CellDrawing::probe(const Cell& cell) {
    inputs_.keep_only({cell.view});
    const LoadedMap& loaded = inputs_.map(cell.view);
    const Technique& technique = library_->get(cell.technique);
    const View& view = cell.view.view;
    const std::string unsupported =
        unsupported_reason(*device_, technique, cell.parameters, view, loaded.map.heights.size);
    if (!unsupported.empty()) fail("{}: {}", cell.id, unsupported);
    Renderer renderer(*device_, technique, cell.parameters, loaded.scene, view, lighting_, object_);
    const std::string maps = renderer.maps_key();
    const FailedPreparations::Failure* known = failed_preparations_.find(maps);
    const std::string given_up = known != nullptr ? known->reason : renderer.prepare(preparation_).given_up;
    if (!given_up.empty()) {
        failed_preparations_.add(maps, {true, given_up});
        fail("{}: {} (--preparation-limit SECONDS)", cell.id, given_up);
    }
    Probe probe = renderer.probe();
    const std::string cut = describe_cut_loops(*device_, probe);
    if (!cut.empty()) log_warning("{}: {}; its picture is not the technique's", cell.id, cut);
    return probe;
}

DrawnCell CellDrawing::beside_truth(const Cell& cell, const Probe& probe) {
    return {probe, inputs_.truth(cell.view), inputs_.map(cell.view).map, cell.view.view.relief};
}

std::optional<ShadowErrors> CellDrawing::shadow_errors(const Cell& cell, const DrawnCell& drawn) const {
    if (cell.view.view.self_shadow.mode == SelfShadow::Mode::off) return std::nullopt;
    return compare_shadows(drawn.probe.light_visibility, drawn.probe.hits, drawn.truth.light_visibility.fractions,
                           drawn.truth.hits, drawn.truth.footprint, drawn.map, drawn.relief, lighting_);
}

HitErrors hit_errors_of(const DrawnCell& drawn) {
    return compare_hits(drawn.probe.hits, drawn.truth.hits, drawn.truth.footprint, drawn.map, drawn.relief);
}

std::string failure_of(const Probe& probe) {
    return reason_of_faults(probe.faults, probe.hits.texels.size());
}

ImageComparison image_errors_of(const DrawnCell& drawn) {
    return compare_images(drawn.probe.colour, drawn.probe.hits, drawn.truth.colour, drawn.truth.hits,
                          {drawn.truth.footprint, drawn.truth.background});
}

}  // namespace reliefbench
