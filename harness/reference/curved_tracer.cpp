#include "reference/curved_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace reliefbench {

namespace {

HeightMap upside_down(const HeightMap& map) {
    HeightMap turned = map;
    for (float& height : turned.heights.texels)
        height = -height;
    return turned;
}

std::string relief_in_words(const HeightMap& map, const BaseMesh& mesh) {
    return fmt::format("the relief of the height map '{}' over the base '{}' of {} triangles", map.name, mesh.name,
                       mesh.triangles.size());
}

/// Where a ray's line is within a box.
struct RayBoxes {
    explicit RayBoxes(const Ray& along) : ray(along), inverse(1.0 / along.direction) {}

    std::pair<double, double> span(const Box& box) const {
        double from = 0;
        double to = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const auto member = static_cast<std::size_t>(axis);
            const double a = (static_cast<double>(box.low[member]) - ray.origin[axis]) * inverse[axis];
            const double b = (static_cast<double>(box.high[member]) - ray.origin[axis]) * inverse[axis];
            // A ray along the side of a box: 0·∞, which neither comparison takes.
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        return {from, to};
    }

    const Ray& ray;
    glm::dvec3 inverse;
};

}  // namespace

CurvedTracer::CurvedTracer(const HeightMap& map, const Relief& relief, double max_pieces)
    : scale_{relief.tiling * map.width(), relief.tiling * map.height(), relief.height_scale},
      maxima_(map),
      walk_(map, maxima_, 0),
      sphere_(bounding_sphere(curved_base(relief.base), relief.height_scale)),
      unresolved_(std::make_unique<std::atomic<std::size_t>>(0)) {
    assert(relief.height_scale > 0 && relief.tiling > 0);
    const BaseMesh& mesh = curved_base(relief.base);
    prisms_.reserve(mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        prisms_.emplace_back(mesh, triangle, scale_);
        folded_ += prisms_.back().has_area() && prisms_.back().is_folded(-relief.height_scale) ? 1 : 0;
    }
    pieces_ = split_relief(prisms_, scale_, map, maxima_, MaximumMipChain(upside_down(map)), sphere_.box_margin(),
                           max_pieces);
    walk_ = ReliefWalk(map, maxima_, pieces_.level);
    boxes_.emplace(pieces_.boxes, relief_in_words(map, mesh));
}

std::optional<CurvedHit> CurvedTracer::trace(const Ray& ray, double before) const {
    const double start = sphere_.way_to(ray);
    const Ray close{ray.origin + start * ray.direction, ray.direction};
    const RayBoxes in_boxes(close);
    std::optional<std::uint32_t> of_terms;
    Prism::RayTerms terms{};
    WalkCounts counts;
    WalkHit nearest{.t = before - start};
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t triangle = none;
    boxes_->visit(close, [&](std::uint32_t index) {
        const ReliefPiece& piece = pieces_.pieces[index];
        const auto [from, to] = in_boxes.span(pieces_.boxes[index]);
        if (from >= nearest.t) return nearest.t;
        const Prism& prism = prisms_[piece.triangle];
        if (piece.triangle != of_terms) {
            terms = prism.terms(close);
            of_terms = piece.triangle;
        }
        const auto hit = walk_.first_hit(prism, terms, piece, close, from, to, counts);
        // Of pieces that share the point the lowest triangle, in whatever order they come.
        if (hit && hit->t >= 0 &&
            (hit->t < nearest.t || (hit->t == nearest.t && triangle != none && piece.triangle < triangle))) {
            nearest = *hit;
            triangle = piece.triangle;
        }
        return nearest.t;
    });
    if (counts.unresolved > 0) *unresolved_ += counts.unresolved;
    if (triangle == none) return std::nullopt;
    return CurvedHit{{.u = (nearest.point.x + 0.5) / scale_.columns,
                      .v = (nearest.point.y + 0.5) / scale_.rows,
                      .h = std::clamp(nearest.point.z, 0.0, 1.0),
                      .t = start + nearest.t},
                     triangle};
}

}  // namespace reliefbench
