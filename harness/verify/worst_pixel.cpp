#include "verify/worst_pixel.hpp"

#include "metrics/error_maps.hpp"

namespace reliefbench {

void WorstPixel::offer(double value, std::size_t pixel) {
    if (!(value > value_)) return;
    value_ = value;
    pixel_ = pixel;
}

std::optional<PixelPlace> WorstPixel::place(Resolution size) const {
    if (value_ <= 0) return std::nullopt;
    return place_of(pixel_, size);
}

std::optional<PixelPlace> worst_place(const TruthComparison& comparison, const HeightMap& map, const View& view,
                                      bool coverage) {
    const HitImage& technique = comparison.probe.hits;
    const HitImage& truth = comparison.truth.hits;
    const Image<float> uv_errors = uv_error_map(compared_hits(comparison, map, view.relief));
    WorstPixel worst;
    for (std::size_t pixel = 0; pixel < truth.texels.size(); ++pixel) {
        if (comparison.truth.footprint.texels[pixel] != in_footprint) continue;
        const bool differs = technique.texels[pixel].is_hit() != truth.texels[pixel].is_hit();
        worst.offer(coverage ? static_cast<double>(differs) : static_cast<double>(uv_errors.texels[pixel]), pixel);
    }
    return worst.place(view.resolution);
}

}  // namespace reliefbench
