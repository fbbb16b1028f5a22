#include "metrics/error_maps.hpp"

#include "core/parallel.hpp"
#include "metrics/pixel_errors.hpp"
#include "scene/shading_normal.hpp"

#include <cassert>
#include <limits>

namespace reliefbench {

namespace {

template <typename Error>
Image<float> map_of(const HitImage& technique, const HitImage& truth, const Error& error) {
    constexpr std::size_t pixels_at_once = 4096;
    assert(technique.size == truth.size);
    Image<float> errors(truth.size, std::numeric_limits<float>::quiet_NaN());
    parallel_for(errors.texels.size(), pixels_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            const Hit& ours = technique.texels[pixel];
            const Hit& theirs = truth.texels[pixel];
            if (is_finite_hit(ours) && theirs.is_hit()) {
                errors.texels[pixel] = static_cast<float>(error(ours, theirs));
            }
        }
    });
    return errors;
}

}  // namespace

Image<float> uv_error_map(const HitImage& technique, const HitImage& truth, const HeightMap& map,
                          const Relief& relief) {
    return map_of(technique, truth,
                  [&](const Hit& ours, const Hit& theirs) { return uv_error(ours, theirs, map, relief); });
}

Image<float> depth_error_map(const HitImage& technique, const HitImage& truth) {
    return map_of(technique, truth, depth_error);
}

Image<float> normal_error_map(const HitImage& technique, const HitImage& truth, const HeightMap& map,
                              const Relief& relief) {
    const Image<std::array<float, 2>> derivatives = height_derivatives(map);
    return map_of(technique, truth, [&](const Hit& ours, const Hit& theirs) {
        return angle_between(shading_normal(derivatives, relief, ours.u, ours.v),
                             shading_normal(derivatives, relief, theirs.u, theirs.v));
    });
}

}  // namespace reliefbench
