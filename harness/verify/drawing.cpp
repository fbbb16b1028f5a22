#include "verify/drawing.hpp"

#include <cassert>
#include <utility>

namespace reliefbench {

Renderer make_renderer(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                       const CoordinateScene& scene, const View& view, MapPreparation& maps) {
    const std::string unsupported = unsupported_reason(device, technique, parameters, view, scene.map.heights.size);
    if (!unsupported.empty()) throw NoPicture(unsupported, true);
    Renderer renderer(device, technique, parameters, scene.on_device, view, coordinate_lighting());
    const Preparation preparation =
        maps.failed.prepare(device, renderer, [&](Renderer& with_maps) { return with_maps.prepare(maps.settings); });
    if (!preparation.given_up.empty()) throw NoPicture(preparation.given_up, true);
    return renderer;
}

void require_picture(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                     const Probe& probe) {
    const DrawVerdict verdict = judge_draw(device, technique.manifest, parameters, probe);
    if (!verdict.reason.empty()) throw NoPicture(verdict.reason, false, verdict.worst);
}

ComparedHits compared_hits(const TruthComparison& comparison, const HeightMap& map, const Relief& relief) {
    const auto& [probe, truth, errors] = comparison;
    ComparedHits hits{probe.hits, truth.hits, truth.footprint, map, relief};
    if (truth.curved) {
        assert(probe.normals);
        const CurvedTruth& curved = *truth.curved;
        hits.curved.emplace(CurvedHits{*probe.normals, curved.normals, curved.entry_triangles, curved.off_chart});
    }
    return hits;
}

TruthComparison beside_truth(Probe probe, const CoordinateScene& scene, const View& view) {
    TruthComparison comparison;
    comparison.truth = trace_exact_truth(scene.map, scene.albedo, view, coordinate_lighting());
    comparison.probe = std::move(probe);
    comparison.errors = compare_hits(compared_hits(comparison, scene.map, view.relief));
    return comparison;
}

TruthComparison compare_with_truth(const gpu::Device& device, const Technique& technique,
                                   const ParameterValues& parameters, const CoordinateScene& scene, const View& view,
                                   const PreparationSettings& preparation) {
    MapPreparation maps{.settings = preparation};
    Probe probe = make_renderer(device, technique, parameters, scene, view, maps).probe();
    const DrawVerdict verdict = judge_draw(device, technique.manifest, parameters, probe);
    if (verdict.is_meaningless) throw NoPicture(verdict.reason, false, verdict.worst);
    return beside_truth(std::move(probe), scene, view);
}

}  // namespace reliefbench
