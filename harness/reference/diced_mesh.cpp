#include "reference/diced_mesh.hpp"

#include "core/error.hpp"
#include "reference/texel_polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace reliefbench {

namespace {

/// Four gigabytes of corners.
constexpr std::size_t max_facets = std::size_t{1} << 27U;
/// In steps of a subdivided texel: parts of triangles that are smaller are left out.
constexpr double least_extent = 1e-9;

using Facet = std::array<TriangleScene::Vertex, 3>;

/// Of one triangle of the base.
class Dicer {
public:
    Dicer(const HeightMap& map, const Relief& relief, const Prism& prism, int subdivision)
        : map_(map), relief_(relief), prism_(prism), subdivision_(subdivision) {}

    /// Calls add(facet) for each.
    template <typename Add>
    void dice(const Add& add) const {
        const TexelRect bounds = texel_bounds(prism_);
        const auto first = glm::floor(bounds.low * static_cast<double>(subdivision_));
        const auto last = glm::ceil(bounds.high * static_cast<double>(subdivision_));
        for (double y = first.y; y < last.y; ++y) {
            for (double x = first.x; x < last.x; ++x) {
                const glm::dvec2 low = glm::dvec2(x, y) / static_cast<double>(subdivision_);
                const glm::dvec2 high = glm::dvec2(x + 1, y + 1) / static_cast<double>(subdivision_);
                add_fan(triangle_in_rect(prism_, {low, high}), add);
            }
        }
    }

private:
    TriangleScene::Vertex vertex(glm::dvec2 texel) const {
        const glm::dvec2 barycentric = prism_.barycentric(texel);
        const double h = map_.sample((texel.x + 0.5) / map_.width(), (texel.y + 0.5) / map_.height());
        const glm::dvec3 normal = glm::normalize(prism_.linear_normal(barycentric));
        const glm::dvec3 point = prism_.foot(barycentric) + (h - 1) * relief_.height_scale * normal;
        return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
    }

    template <typename Add>
    void add_fan(const TexelPolygon& polygon, const Add& add) const {
        if (polygon.count < 3) return;
        std::array<TriangleScene::Vertex, TexelPolygon::max_corners> vertices;
        for (std::size_t corner = 0; corner < polygon.count; ++corner)
            vertices[corner] = vertex(polygon.corners[corner]);
        for (std::size_t corner = 1; corner + 1 < polygon.count; ++corner) {
            const glm::dvec2 first = polygon.corners[corner] - polygon.corners[0];
            const glm::dvec2 second = polygon.corners[corner + 1] - polygon.corners[0];
            const double area = std::abs(first.x * second.y - first.y * second.x);
            if (area * subdivision_ * subdivision_ < least_extent) continue;
            add(Facet{vertices[0], vertices[corner], vertices[corner + 1]});
        }
    }

    const HeightMap& map_;
    const Relief& relief_;
    const Prism& prism_;
    int subdivision_;
};

}  // namespace

DicedMesh::DicedMesh(const HeightMap& map, const Relief& relief, int subdivision)
    : map_(&map),
      relief_(relief),
      scale_{relief.tiling * map.width(), relief.tiling * map.height(), relief.height_scale},
      sphere_(bounding_sphere(curved_base(relief.base), relief.height_scale)),
      entries_(curved_base(relief.base)) {
    assert(subdivision >= 1);
    const BaseMesh& mesh = curved_base(relief.base);
    std::vector<TriangleScene::Vertex> vertices;
    prisms_.reserve(mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        prisms_.emplace_back(mesh, triangle, scale_);
        if (!prisms_.back().has_area()) continue;
        Dicer(map, relief_, prisms_.back(), subdivision).dice([&](const Facet& facet) {
            vertices.insert(vertices.end(), facet.begin(), facet.end());
            triangles_.push_back(static_cast<std::uint32_t>(triangle));
            if (triangles_.size() <= max_facets) return;
            fail(
                "the base '{}' diced by the height map '{}' with subdivision {} and tiling {} would have more than {} "
                "facets: lower the subdivision, the tiling or the map's size, or use the exact truth",
                mesh.name, map.name, subdivision, relief.tiling, max_facets);
        });
    }
    facets_.emplace(vertices, fmt::format("the base '{}' diced by the height map '{}'", mesh.name, map.name));
}

std::optional<CurvedHit> DicedMesh::trace(const Ray& ray) const {
    const std::optional<MeshEntry> entry = entries_.find(ray);
    const bool is_entered_on_surface = entry && map_->sample(relief_.tiling * entry->entry.uv.x,
                                                             relief_.tiling * entry->entry.uv.y) >= 1 - entry_tolerance;
    const double start = sphere_.way_to(ray);
    const Ray close{ray.origin + start * ray.direction, ray.direction};
    const std::optional<TriangleScene::Met> met = facets_->first_front(close);
    if (is_entered_on_surface && (!met || entry->entry.t <= start + met->t + sphere_.box_margin()))
        return CurvedHit{{entry->entry.uv.x, entry->entry.uv.y, 1, entry->entry.t}, entry->triangle};
    if (!met) return std::nullopt;
    const std::uint32_t triangle = triangles_[met->triangle];
    const Prism& prism = prisms_[triangle];
    Prism::Along along;
    if (!prism.locate(close, prism.terms(close), met->t, -relief_.height_scale / 2, along)) return std::nullopt;
    return CurvedHit{{.u = (along.point.x + 0.5) / scale_.columns,
                      .v = (along.point.y + 0.5) / scale_.rows,
                      .h = std::clamp(along.point.z, 0.0, 1.0),
                      .t = start + met->t},
                     triangle};
}

}  // namespace reliefbench
