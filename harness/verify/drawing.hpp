#pragma once

#include "core/error.hpp"
#include "metrics/compared_hits.hpp"
#include "metrics/hit_errors.hpp"
#include "reference/truth.hpp"
#include "scene/pixel_place.hpp"
#include "technique/draw_verdict.hpp"
#include "technique/failed_preparations.hpp"
#include "technique/renderer.hpp"
#include "verify/circumstance.hpp"

#include <optional>
#include <string>

namespace reliefbench {

/// There is no picture of the technique's to check. The message is the reason that a run would give for the cell, which
/// it would call skipped or failed.
struct NoPicture : Error {
    NoPicture(const std::string& reason, bool is_skipped, std::optional<PixelPlace> place = {})
        : Error(reason), skipped(is_skipped), worst(place) {}

    bool skipped = false;
    /// DrawVerdict::worst.
    std::optional<PixelPlace> worst;
};

/// How derived maps are made for what is drawn.
struct MapPreparation {
    PreparationSettings settings = {};
    FailedPreparations failed = {};
};

/// Compiled and prepared. Skipped where the device cannot run it, or its preparation would pass the limit.
Renderer make_renderer(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                       const CoordinateScene& scene, const View& view, MapPreparation& maps);

/// NoPicture where the draw is not the technique's (technique/draw_verdict.hpp).
void require_picture(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                     const Probe& probe);

/// What a technique found and what it should have.
struct TruthComparison {
    Probe probe;
    Truth truth;
    HitErrors errors;
};

/// Valid as long as all three.
ComparedHits compared_hits(const TruthComparison& comparison, const HeightMap& map, const Relief& relief);

TruthComparison beside_truth(Probe probe, const CoordinateScene& scene, const View& view);

/// Draws the probed compilation and traces the exact truth beside it, whether or not the picture is the technique's.
/// Answers out of range are NoPicture, for there is nothing to compare.
TruthComparison compare_with_truth(const gpu::Device& device, const Technique& technique,
                                   const ParameterValues& parameters, const CoordinateScene& scene, const View& view,
                                   const PreparationSettings& preparation = {});

}  // namespace reliefbench
