#include "technique/pipeline/draw_pipeline.hpp"

#include "technique/renderer.hpp"

#include <algorithm>
#include <cassert>

namespace reliefbench {

/// Each in a file of its own, which nobody needs but this list.
/// The quad of the patch as a triangle strip, or the triangles of a base that is not flat: their fragments search the
/// relief.
DrawPipeline raster_pipeline();
/// Real geometry: a grid of patches through the technique's tessellation stages.
DrawPipeline tessellation_pipeline();

const std::vector<DrawPipeline>& draw_pipelines() {
    static const std::vector<DrawPipeline> pipelines{raster_pipeline(), tessellation_pipeline()};
    return pipelines;
}

const DrawPipeline& pipeline_of(const Manifest& manifest) {
    const auto found = std::ranges::find(draw_pipelines(), manifest.shape.kind, &DrawPipeline::shape);
    assert(found != draw_pipelines().end());
    return *found;
}

double range_tolerance(const Manifest& manifest) {
    return pipeline_of(manifest).range_tolerance;
}

}  // namespace reliefbench
