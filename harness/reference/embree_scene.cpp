#include "reference/embree_scene.hpp"

#include "reference/embree_handles.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

constexpr const char* remedy = "lower the tiling, the subdivision, or the size of base or map";

/// Embree hands back the pointer to `context`, which is the pointer to all of it.
struct VisitContext {
    RTCIntersectContext context;
    void* visitor;
    double (*call)(void* visitor, std::uint32_t box);
};
static_assert(std::is_standard_layout_v<VisitContext>);

void give_bounds(const RTCBoundsFunctionArguments* arguments) {
    const Box& box = static_cast<const Box*>(arguments->geometryUserPtr)[arguments->primID];
    RTCBounds& bounds = *arguments->bounds_o;
    bounds.lower_x = box.low[0];
    bounds.lower_y = box.low[1];
    bounds.lower_z = box.low[2];
    bounds.upper_x = box.high[0];
    bounds.upper_y = box.high[1];
    bounds.upper_z = box.high[2];
}

void visit_box(const RTCIntersectFunctionNArguments* arguments) {
    assert(arguments->N == 1);
    if (arguments->valid[0] == 0) return;
    const auto* visit = reinterpret_cast<const VisitContext*>(arguments->context);
    const double end = visit->call(visit->visitor, arguments->primID);
    auto& query = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
    if (end >= static_cast<double>(query.ray.tfar)) return;
    query.ray.tfar = std::nextafter(static_cast<float>(end), std::numeric_limits<float>::infinity());
    query.hit.geomID = arguments->geomID;
    query.hit.primID = arguments->primID;
}

/// Back faces are transparent.
void reject_back_face(const RTCFilterFunctionNArguments* arguments) {
    assert(arguments->N == 1);
    const float along = RTCHitN_Ng_x(arguments->hit, 1, 0) * RTCRayN_dir_x(arguments->ray, 1, 0) +
                        RTCHitN_Ng_y(arguments->hit, 1, 0) * RTCRayN_dir_y(arguments->ray, 1, 0) +
                        RTCHitN_Ng_z(arguments->hit, 1, 0) * RTCRayN_dir_z(arguments->ray, 1, 0);
    if (along >= 0) arguments->valid[0] = 0;
}

}  // namespace

struct BoxScene::Scene : embree::BuiltScene {};
struct TriangleScene::Scene : embree::BuiltScene {};

BoxScene::BoxScene(std::span<const Box> boxes, const std::string& what) : scene_(std::make_unique<Scene>()) {
    embree::build(*scene_, RTC_GEOMETRY_TYPE_USER, what, remedy, [&](RTCGeometry geometry) {
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
        // Only read, while the scene is committed.
        rtcSetGeometryUserData(geometry, const_cast<Box*>(boxes.data()));
        rtcSetGeometryBoundsFunction(geometry, give_bounds, nullptr);
        rtcSetGeometryIntersectFunction(geometry, visit_box);
        return true;
    });
}

BoxScene::~BoxScene() = default;
BoxScene::BoxScene(BoxScene&&) noexcept = default;
BoxScene& BoxScene::operator=(BoxScene&&) noexcept = default;

void BoxScene::visit_boxes(const Ray& ray, void* visitor, double (*call)(void* visitor, std::uint32_t box)) const {
    VisitContext context{};
    rtcInitIntersectContext(&context.context);
    context.visitor = visitor;
    context.call = call;
    RTCRayHit query = embree::first_hit_query(ray);
    rtcIntersect1(scene_->scene.get(), &context.context, &query);
}

TriangleScene::TriangleScene(std::span<const Vertex> vertices, const std::string& what)
    : scene_(std::make_unique<Scene>()) {
    assert(vertices.size() % 3 == 0);
    embree::build(*scene_, RTC_GEOMETRY_TYPE_TRIANGLE, what, remedy, [&](RTCGeometry geometry) {
        void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex),
                                                vertices.size());
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                3 * sizeof(unsigned), vertices.size() / 3);
        if (!corners || !indices) return false;
        std::ranges::copy(vertices, static_cast<Vertex*>(corners));
        for (std::size_t index = 0; index < vertices.size(); ++index)
            static_cast<unsigned*>(indices)[index] = static_cast<unsigned>(index);
        rtcSetGeometryIntersectFilterFunction(geometry, reject_back_face);
        return true;
    });
}

TriangleScene::~TriangleScene() = default;
TriangleScene::TriangleScene(TriangleScene&&) noexcept = default;
TriangleScene& TriangleScene::operator=(TriangleScene&&) noexcept = default;

std::optional<TriangleScene::Met> TriangleScene::first_front(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query = embree::first_hit_query(ray);
    rtcIntersect1(scene_->scene.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Met{query.hit.primID, static_cast<double>(query.ray.tfar)};
}

}  // namespace reliefbench
