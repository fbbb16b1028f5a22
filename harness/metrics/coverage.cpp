#include "metrics/coverage.hpp"

#include "metrics/pixel_errors.hpp"

#include <cassert>

namespace reliefbench {

Image<Coverage> coverage_map(const ComparedHits& hits) {
    const HitImage& technique = hits.technique;
    const HitImage& truth = hits.truth;
    const FootprintImage& footprint = hits.footprint;
    assert(technique.size == truth.size && footprint.size == truth.size);
    Image<Coverage> map(truth.size);
    for (std::size_t pixel = 0; pixel < map.texels.size(); ++pixel) {
        const bool ours = is_finite_hit(technique.texels[pixel]);
        const bool theirs = truth.texels[pixel].is_hit();
        if (footprint.texels[pixel] == tie_in_footprint) {
            map.texels[pixel] = Coverage::tie;
        } else if (footprint.texels[pixel] == 0 && hits.ends_with_footprint()) {
            map.texels[pixel] = Coverage::neither;
        } else if (ours) {
            map.texels[pixel] = theirs ? Coverage::both : Coverage::false_hit;
        } else if (theirs) {
            map.texels[pixel] = footprint.texels[pixel] != 0 ? Coverage::missed : Coverage::missed_outside;
        }
    }
    return map;
}

}  // namespace reliefbench
