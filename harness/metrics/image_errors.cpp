#include "metrics/image_errors.hpp"

#include "scene/colour.hpp"

#include <cassert>
#include <cmath>

namespace reliefbench {

ImageErrors compare_images(const Image<std::array<float, 3>>& technique, const HitImage& technique_hits,
                           const Image<std::array<float, 3>>& truth, const HitImage& truth_hits) {
    assert(technique.size == truth.size && technique_hits.size == truth.size && truth_hits.size == truth.size);
    double sum_of_squares = 0;
    std::size_t values = 0;
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        if (!technique_hits.texels[pixel].is_hit() && !truth_hits.texels[pixel].is_hit()) {
            continue;
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double difference =
                srgb_encode(technique.texels[pixel][channel]) - srgb_encode(truth.texels[pixel][channel]);
            sum_of_squares += difference * difference;
            ++values;
        }
    }
    ImageErrors errors;
    if (values == 0) {
        return errors;
    }
    errors.rmse = std::sqrt(sum_of_squares / static_cast<double>(values));
    if (*errors.rmse > 0) {
        errors.psnr = -20 * std::log10(*errors.rmse);
    }
    return errors;
}

}  // namespace reliefbench
