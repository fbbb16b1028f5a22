#include "metrics/hit_errors.hpp"

#include "core/parallel.hpp"
#include "metrics/pixel_errors.hpp"
#include "scene/shading_normal.hpp"

#include <cassert>
#include <cmath>
#include <vector>

namespace reliefbench {

namespace {

/// Pixels per range of the parallel loop.
constexpr std::size_t grain = 4096;

struct PixelCounts {
    std::size_t missed = 0;
    std::size_t false_hits = 0;
    std::size_t ties = 0;
    std::size_t covered_outside = 0;
    std::size_t covered_by_both = 0;
    std::size_t covered_by_either = 0;
};

void set_coverage(HitErrors& errors, const PixelCounts& counts) {
    if (errors.footprint > 0) {
        const auto footprint = static_cast<double>(errors.footprint);
        errors.missed = static_cast<double>(counts.missed) / footprint;
        errors.false_hits = static_cast<double>(counts.false_hits) / footprint;
        errors.ties = static_cast<double>(counts.ties) / footprint;
    }
    if (errors.outside_quad_pixels > 0) {
        errors.outside_quad_covered =
            static_cast<double>(counts.covered_outside) / static_cast<double>(errors.outside_quad_pixels);
    }
    if (counts.covered_by_either > 0) {
        errors.coverage_iou =
            static_cast<double>(counts.covered_by_both) / static_cast<double>(counts.covered_by_either);
    }
}

void set_distances(HitErrors& errors, const std::vector<std::size_t>& compared, const HitImage& technique,
                   const HitImage& truth, const HeightMap& map, const Relief& relief) {
    if (compared.empty()) {
        return;
    }
    const Image<std::array<float, 2>> derivatives = height_derivatives(map);
    std::vector<double> uv(compared.size());
    std::vector<double> signed_depth(compared.size());
    std::vector<double> depth(compared.size());
    std::vector<double> normal(compared.size());
    parallel_for(compared.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const Hit& ours = technique.texels[compared[index]];
            const Hit& theirs = truth.texels[compared[index]];
            uv[index] = uv_error(ours, theirs, map, relief);
            signed_depth[index] = depth_error(ours, theirs);
            depth[index] = std::abs(signed_depth[index]);
            normal[index] = angle_between(shading_normal(derivatives, relief, ours.u, ours.v),
                                          shading_normal(derivatives, relief, theirs.u, theirs.v));
        }
    });
    errors.uv_texels = summarize(uv);
    errors.depth = summarize(depth);
    errors.depth->mean = summarize(signed_depth).mean;
    errors.normal_deg = summarize(normal);
}

}  // namespace

HitErrors compare_hits(const HitImage& technique, const HitImage& truth, const FootprintImage& footprint,
                       const HeightMap& map, const Relief& relief) {
    assert(technique.size == truth.size && footprint.size == truth.size);
    HitErrors errors;
    PixelCounts counts;
    std::vector<std::size_t> compared;
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        const bool inside = footprint.texels[pixel] != 0;
        if (footprint.texels[pixel] == tie_in_footprint) {
            ++errors.footprint;
            ++counts.ties;
            continue;
        }
        const bool ours = is_finite_hit(technique.texels[pixel]);
        const bool theirs = truth.texels[pixel].is_hit();
        if (inside || relief.boundary == Boundary::clip) {
            counts.covered_by_both += ours && theirs ? 1 : 0;
            counts.covered_by_either += ours || theirs ? 1 : 0;
        }
        if (inside) {
            ++errors.footprint;
            counts.missed += theirs && !ours ? 1 : 0;
            counts.false_hits += ours && !theirs ? 1 : 0;
            if (ours && theirs) compared.push_back(pixel);
        } else if (theirs) {
            ++errors.outside_quad_pixels;
            counts.covered_outside += ours ? 1 : 0;
        }
    }
    errors.compared = compared.size();
    set_coverage(errors, counts);
    set_distances(errors, compared, technique, truth, map, relief);
    return errors;
}

}  // namespace reliefbench
