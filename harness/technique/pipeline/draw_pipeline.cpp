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
/// The tetrahedra between the base and the floor of its relief, whose fragments search the piece of the ray in each.
DrawPipeline shell_pipeline();

const std::vector<DrawPipeline>& draw_pipelines() {
    static const std::vector<DrawPipeline> pipelines{raster_pipeline(), tessellation_pipeline(), shell_pipeline()};
    return pipelines;
}

const DrawPipeline& pipeline_of(const Manifest& manifest) {
    const auto found = std::ranges::find(draw_pipelines(), manifest.shape.kind, &DrawPipeline::shape);
    assert(found != draw_pipelines().end());
    return *found;
}

BaseSurface drawn_base(const Manifest& manifest, const BaseSurface& base) {
    return pipeline_of(manifest).needs_triangles ? triangulated(base) : base;
}

double range_tolerance(const Manifest& manifest) {
    return pipeline_of(manifest).range_tolerance;
}

}  // namespace reliefbench
