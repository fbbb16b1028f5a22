#include "metrics/hit_errors.hpp"

#include "core/parallel.hpp"
#include "scene/shading_normal.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cassert>
#include <cmath>
#include <vector>

namespace reliefbench {

namespace {

/// Pixels per range of the parallel loop.
constexpr std::size_t grain = 4096;

double uv_error(const Hit& technique, const Hit& truth, const HeightMap& map, const Relief& relief) {
    const double du = static_cast<double>(technique.u) - truth.u;
    const double dv = static_cast<double>(technique.v) - truth.v;
    return std::hypot(du * relief.tiling * map.width(), dv * relief.tiling * map.height());
}

/// Degrees; accurate for small angles, which the arc cosine is not.
double angle_between(glm::dvec3 a, glm::dvec3 b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

struct PixelCounts {
    std::size_t missed = 0;
    std::size_t false_hits = 0;
    std::size_t covered_outside = 0;
    std::size_t covered_by_both = 0;
    std::size_t covered_by_either = 0;
};

void set_coverage(HitErrors& errors, const PixelCounts& counts) {
    if (errors.footprint > 0) {
        const auto footprint = static_cast<double>(errors.footprint);
        errors.missed = static_cast<double>(counts.missed) / footprint;
        errors.false_hits = static_cast<double>(counts.false_hits) / footprint;
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
            signed_depth[index] = static_cast<double>(ours.t) - theirs.t;
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

bool is_finite_hit(const Hit& hit) {
    return hit.is_hit() && std::isfinite(hit.u) && std::isfinite(hit.v) && std::isfinite(hit.t);
}

HitErrors compare_hits(const HitImage& technique, const HitImage& truth, const Image<std::uint8_t>& footprint,
                       const HeightMap& map, const Relief& relief) {
    assert(technique.size == truth.size && footprint.size == truth.size);
    HitErrors errors;
    PixelCounts counts;
    std::vector<std::size_t> compared;
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        const bool inside = footprint.texels[pixel] != 0;
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

Image<float> uv_error_map(const HitImage& technique, const HitImage& truth, const HeightMap& map,
                          const Relief& relief) {
    assert(technique.size == truth.size);
    Image<float> errors(truth.size, -1.0F);
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        const Hit& ours = technique.texels[pixel];
        const Hit& theirs = truth.texels[pixel];
        if (is_finite_hit(ours) && theirs.is_hit()) {
            errors.texels[pixel] = static_cast<float>(uv_error(ours, theirs, map, relief));
        }
    }
    return errors;
}

}  // namespace reliefbench
