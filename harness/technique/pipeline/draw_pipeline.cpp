#include "technique/pipeline/draw_pipeline.hpp"

#include "technique/renderer.hpp"

#include <algorithm>
#include <cassert>

namespace reliefbench {

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
