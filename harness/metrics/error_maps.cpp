#include "metrics/error_maps.hpp"

#include "core/parallel.hpp"
#include "metrics/pixel_errors.hpp"

#include <cassert>
#include <limits>

namespace reliefbench {

namespace {

/// `error` is called with each pixel in which both hit.
template <typename Error>
Image<float> map_of(const ComparedHits& hits, const Error& error) {
    constexpr std::size_t pixels_at_once = 4096;
    assert(hits.technique.size == hits.truth.size);
    Image<float> errors(hits.truth.size, std::numeric_limits<float>::quiet_NaN());
    parallel_for(errors.texels.size(), pixels_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            if (is_finite_hit(hits.technique.texels[pixel]) && hits.truth.texels[pixel].is_hit()) {
                errors.texels[pixel] = static_cast<float>(error(pixel));
            }
        }
    });
    return errors;
}

}  // namespace

Image<float> uv_error_map(const ComparedHits& hits) {
    return map_of(hits, [&](std::size_t pixel) {
        return hits.is_off_chart(pixel) ? std::numeric_limits<double>::quiet_NaN()
                                        : uv_error(hits.technique.texels[pixel], hits.truth.texels[pixel], hits.map,
                                                   hits.relief, hits.chart_period(pixel));
    });
}

Image<float> depth_error_map(const ComparedHits& hits) {
    return map_of(
        hits, [&](std::size_t pixel) { return depth_error(hits.technique.texels[pixel], hits.truth.texels[pixel]); });
}

Image<float> normal_error_map(const ComparedHits& hits) {
    const ShadingNormals normals(hits);
    return map_of(
        hits, [&](std::size_t pixel) { return angle_between(normals.of_technique(pixel), normals.of_truth(pixel)); });
}

}  // namespace reliefbench
