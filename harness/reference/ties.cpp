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
    return find({&ray, 1}).front();
}

std::vector<bool> TieFinder::find(std::span<const Ray> rays) const {
    // A shift in u or v raises or lowers the surface under the ray by no more than `lift_`, so that the shifted rays'
    // hits lie between those of the ray lowered and raised by it: where these agree no shift can tell.
    std::vector<Ray> lowered;
    std::vector<Ray> raised;
    for (const Ray& ray : rays) {
        lowered.push_back(lifted(ray, -lift_));
        raised.push_back(lifted(ray, lift_));
    }
    const auto below = trace(lowered);
    const auto above = trace(raised);

    const double du = tie_shift_texels / columns_;
    const double dv = tie_shift_texels / rows_;
    const std::array<glm::dvec3, 5> shifts{{{0, 0, 0}, {du, 0, 0}, {-du, 0, 0}, {0, dv, 0}, {0, -dv, 0}}};
    std::vector<std::size_t> suspects;
    std::vector<Ray> shifted_rays;
    for (std::size_t index = 0; index < rays.size(); ++index) {
        if (!is_near_border(rays[index]) && !differ(below[index], above[index])) continue;
        suspects.push_back(index);
        for (const glm::dvec3& shift : shifts)
            shifted_rays.push_back(shifted(plane_, rays[index], shift));
    }
    const auto hits = trace(shifted_rays);
    std::vector<bool> ties(rays.size(), false);
    for (std::size_t suspect = 0; suspect < suspects.size(); ++suspect) {
        const auto of_suspect = std::span(hits).subspan(suspect * shifts.size(), shifts.size());
        ties[suspects[suspect]] = std::ranges::any_of(
            of_suspect, [&](const std::optional<ExactHit>& hit) { return differ(of_suspect.front(), hit); });
    }
    return ties;
}

Ray TieFinder::lifted(const Ray& ray, double by) const {
    // Parallel rays of a plane start on it: a lowered one has to come from above as well.
    const Ray earlier = started_above(plane_, ray, lift_ * height_scale_);
    return shifted(plane_, earlier, {0, 0, by * height_scale_});
}

std::vector<std::optional<ExactHit>> TieFinder::trace(std::span<const Ray> rays) const {
    std::vector<std::optional<ExactHit>> hits(rays.size());
    tracer_->trace(rays, hits);
    return hits;
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
