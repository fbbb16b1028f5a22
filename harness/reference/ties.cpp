#include "reference/ties.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace reliefbench {

TieFinder::TieFinder(const HeightMap& map, const Relief& relief, const ExactTracer& tracer)
    : tracer_(&tracer),
      plane_(flat_base(relief.base)),
      height_scale_(relief.height_scale),
      clip_(relief.boundary == Boundary::clip),
      columns_(relief.tiling * map.width()),
      rows_(relief.tiling * map.height()),
      lift_(1.01 * tie_shift_texels) {}

bool TieFinder::is_tie(const Ray& ray) const {
    // A shift in u or v raises or lowers the surface under the ray by no more than `lift_`, so that the shifted rays'
    // hits lie between those of the ray lowered and raised by it: where these agree no shift can tell.
    if (!is_near_border(ray)) {
        const auto lifted = [&](double by) {
            // Parallel rays of a plane start on it: a lowered one has to come from above as well.
            const Ray earlier = started_above(plane_, ray, lift_ * height_scale_);
            return tracer_->trace(shifted(plane_, earlier, {0, 0, by * height_scale_}));
        };
        if (!differ(lifted(-lift_), lifted(lift_))) return false;
    }
    const std::optional<ExactHit> hit = tracer_->trace(ray);
    const double du = tie_shift_texels / columns_;
    const double dv = tie_shift_texels / rows_;
    const std::array<glm::dvec3, 4> shifts{{{du, 0, 0}, {-du, 0, 0}, {0, dv, 0}, {0, -dv, 0}}};
    return std::any_of(shifts.begin(), shifts.end(), [&](const glm::dvec3& shift) {
        return differ(hit, tracer_->trace(shifted(plane_, ray, shift)));
    });
}

bool TieFinder::differ(const std::optional<ExactHit>& a, const std::optional<ExactHit>& b) const {
    if (!a || !b) return a.has_value() != b.has_value();
    return std::hypot((a->u - b->u) * columns_, (a->v - b->v) * rows_) > tie_jump_texels;
}

bool TieFinder::is_near_border(const Ray& ray) const {
    if (!clip_) return false;
    const std::optional<BaseEntry> entry = find_entry(plane_, ray);
    if (!entry) return true;
    const double u = entry->uv.x;
    const double v = entry->uv.y;
    const double near = 2 * tie_shift_texels;
    return std::min(u, 1 - u) * columns_ < near || std::min(v, 1 - v) * rows_ < near;
}

}  // namespace reliefbench
