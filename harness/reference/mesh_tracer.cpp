#include "reference/mesh_tracer.hpp"

#include "reference/embree_handles.hpp"
#include "reference/vertex_grid.hpp"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace reliefbench {
namespace {

/// Rays start this far above the plane, so that single precision cannot lose a hit at their very start.
constexpr double start_height = 1e-3;

/// Cells along a side of one of Embree's grids, at most 32,766; small enough that grids are built in parallel.
constexpr int cells_per_grid = 256;

/// What the hit filter needs to know about a ray; Embree hands back the pointer to `context`.
struct TracedRay {
    RTCIntersectContext context;
    glm::dvec3 origin;
    glm::dvec3 direction;
    Plane plane;
    bool clip;
};
static_assert(std::is_standard_layout_v<RTCIntersectContext>);

/// Back faces are transparent, and with Boundary::clip so is all that lies outside the unit square: the ray goes on.
void reject_transparent(const RTCFilterFunctionNArguments* arguments) {
    assert(arguments->N == 1);
    const auto* ray = reinterpret_cast<const TracedRay*>(arguments->context);
    glm::dvec3 normal{RTCHitN_Ng_x(arguments->hit, 1, 0), RTCHitN_Ng_y(arguments->hit, 1, 0),
                      RTCHitN_Ng_z(arguments->hit, 1, 0)};
    if (normal.z < 0) normal = -normal;
    const double t = RTCRayN_tfar(arguments->ray, 1, 0);
    const bool outside = is_beside(ray->plane, ray->origin + t * ray->direction);
    const bool from_below = glm::dot(normal, ray->direction) >= 0;
    if (from_below || (ray->clip && outside)) arguments->valid[0] = 0;
}

void fill_grids(RTCGeometry geometry, const VertexGrid& mesh) {
    std::vector<RTCGrid> grids;
    for (int row = 0; row + 1 < mesh.rows; row += cells_per_grid) {
        for (int column = 0; column + 1 < mesh.columns; column += cells_per_grid) {
            const auto width = static_cast<unsigned short>(std::min(cells_per_grid + 1, mesh.columns - column));
            const auto height = static_cast<unsigned short>(std::min(cells_per_grid + 1, mesh.rows - row));
            const unsigned first = static_cast<unsigned>(row) * mesh.columns + static_cast<unsigned>(column);
            grids.push_back({first, static_cast<unsigned>(mesh.columns), width, height});
        }
    }
    void* buffer =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), grids.size());
    if (buffer) std::copy(grids.begin(), grids.end(), static_cast<RTCGrid*>(buffer));
}

void fill_triangles(RTCGeometry geometry, const VertexGrid& mesh) {
    using Triangle = std::array<unsigned, 3>;
    const std::size_t cells = static_cast<std::size_t>(mesh.columns - 1) * static_cast<std::size_t>(mesh.rows - 1);
    void* buffer =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), 2 * cells);
    if (!buffer) return;
    auto* triangle = static_cast<Triangle*>(buffer);
    const auto columns = static_cast<unsigned>(mesh.columns);
    for (unsigned row = 0; row + 1 < static_cast<unsigned>(mesh.rows); ++row) {
        for (unsigned column = 0; column + 1 < columns; ++column) {
            const unsigned corner = row * columns + column;
            *triangle++ = {corner, corner + 1, corner + columns};
            *triangle++ = {corner + 1, corner + columns + 1, corner + columns};
        }
    }
}

}  // namespace

struct MeshTracer::Scene {
    embree::BuiltScene built;
    const HeightMap* map = nullptr;
    Relief relief;
    Plane plane;
    bool clip = false;

    /// Of the bilinear surface, which every mesh shares at h = 1: entry_tolerance.
    bool is_entered_on_surface(double u, double v) const {
        if (clip && (u < 0 || u > 1 || v < 0 || v > 1)) return false;
        return map->sample(relief.tiling * u, relief.tiling * v) >= 1 - entry_tolerance;
    }
};

MeshTracer::MeshTracer(const HeightMap& map, const View& view, int subdivision, Geometry kind)
    : scene_(std::make_unique<Scene>()) {
    scene_->map = &map;
    scene_->relief = view.relief;
    scene_->plane = flat_base(view.relief.base);
    scene_->clip = view.relief.boundary == Boundary::clip;
    const PatchRegion region =
        scene_->clip ? PatchRegion{} : visible_region(scene_->plane, view.camera, view.relief.height_scale);
    const VertexGrid mesh = enclosing_grid(map, view.relief, region.low, region.high, subdivision);

    const RTCGeometryType type = kind == Geometry::grid ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE;
    const std::string what =
        fmt::format("the mesh of {}x{} vertices for the height map '{}'", mesh.columns, mesh.rows, map.name);
    constexpr const char* remedy = "lower the subdivision or the tiling, or use the exact truth";
    embree::build(scene_->built, type, what, remedy, [&](RTCGeometry geometry) {
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex),
                                                 mesh.vertices());
        if (!vertices) return false;
        displace(map, view.relief, mesh, std::span(static_cast<Vertex*>(vertices), mesh.vertices()));
        kind == Geometry::grid ? fill_grids(geometry, mesh) : fill_triangles(geometry, mesh);
        rtcSetGeometryIntersectFilterFunction(geometry, reject_transparent);
        return true;
    });
}

MeshTracer::~MeshTracer() = default;
MeshTracer::MeshTracer(MeshTracer&&) noexcept = default;
MeshTracer& MeshTracer::operator=(MeshTracer&&) noexcept = default;

std::optional<ExactHit> MeshTracer::trace(const Ray& ray) const {
    if (!descends(scene_->plane, ray)) return std::nullopt;
    // Embree counts in single precision: the shorter the way from the ray's start to the relief, the less is lost.
    const double t_top = crossing_t(scene_->plane, ray);
    const glm::dvec3 entry = base_coordinates(scene_->plane, ray.origin + t_top * ray.direction);
    if (t_top >= 0 && scene_->is_entered_on_surface(entry.x, entry.y)) return ExactHit{entry.x, entry.y, 1, t_top};
    const double t_start = t_top + rise_t(scene_->plane, ray, start_height);

    TracedRay traced{};
    rtcInitIntersectContext(&traced.context);
    traced.origin = ray.origin + t_start * ray.direction;
    traced.direction = ray.direction;
    traced.plane = scene_->plane;
    traced.clip = scene_->clip;

    RTCRayHit query = embree::first_hit_query({traced.origin, traced.direction});
    rtcIntersect1(scene_->built.scene.get(), &traced.context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const double t = std::max(t_start + static_cast<double>(query.ray.tfar), t_top);
    const glm::dvec3 found = base_coordinates(scene_->plane, ray.origin + t * ray.direction);
    return ExactHit{found.x, found.y, std::clamp(1 + found.z / scene_->relief.height_scale, 0.0, 1.0), t};
}

}  // namespace reliefbench
