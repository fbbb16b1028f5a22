#include "reference/embree_scene.hpp"

#include "core/error.hpp"
#include "reference/embree_handles.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace reliefbench {

namespace {

/// Calls fill(geometry) before the geometry is committed.
template <typename Fill>
void build(embree::BuiltScene& built, RTCGeometryType type, const std::string& what, const Fill& fill) {
    built.device.reset(rtcNewDevice(embree::configuration));
    if (!built.device) fail("Embree gives no device for {}: check the package libembree3-3", what);
    rtcSetDeviceErrorFunction(built.device.get(), embree::keep_message, &built.message);
    built.scene.reset(rtcNewScene(built.device.get()));
    rtcSetSceneFlags(built.scene.get(), RTC_SCENE_FLAG_ROBUST);
    const embree::GeometryHandle geometry(rtcNewGeometry(built.device.get(), type));
    fill(geometry.get());
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(built.scene.get(), geometry.get());
    rtcCommitScene(built.scene.get());
    if (rtcGetDeviceError(built.device.get()) == RTC_ERROR_NONE) return;
    fail("Embree cannot build {} ({}): lower the tiling, the subdivision, or the size of base or map", what,
         built.message);
}

RTCRayHit embree_query(const Ray& ray) {
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(ray.origin.x);
    query.ray.org_y = static_cast<float>(ray.origin.y);
    query.ray.org_z = static_cast<float>(ray.origin.z);
    query.ray.dir_x = static_cast<float>(ray.direction.x);
    query.ray.dir_y = static_cast<float>(ray.direction.y);
    query.ray.dir_z = static_cast<float>(ray.direction.z);
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return query;
}

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
    build(*scene_, RTC_GEOMETRY_TYPE_USER, what, [&](RTCGeometry geometry) {
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
        // Only read, while the scene is committed.
        rtcSetGeometryUserData(geometry, const_cast<Box*>(boxes.data()));
        rtcSetGeometryBoundsFunction(geometry, give_bounds, nullptr);
        rtcSetGeometryIntersectFunction(geometry, visit_box);
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
    RTCRayHit query = embree_query(ray);
    rtcIntersect1(scene_->scene.get(), &context.context, &query);
}

TriangleScene::TriangleScene(std::span<const Vertex> vertices, const std::string& what)
    : scene_(std::make_unique<Scene>()) {
    assert(vertices.size() % 3 == 0);
    build(*scene_, RTC_GEOMETRY_TYPE_TRIANGLE, what, [&](RTCGeometry geometry) {
        void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex),
                                                vertices.size());
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                3 * sizeof(unsigned), vertices.size() / 3);
        if (!corners || !indices) return;
        std::ranges::copy(vertices, static_cast<Vertex*>(corners));
        for (std::size_t index = 0; index < vertices.size(); ++index)
            static_cast<unsigned*>(indices)[index] = static_cast<unsigned>(index);
        rtcSetGeometryIntersectFilterFunction(geometry, reject_back_face);
    });
}

TriangleScene::~TriangleScene() = default;
TriangleScene::TriangleScene(TriangleScene&&) noexcept = default;
TriangleScene& TriangleScene::operator=(TriangleScene&&) noexcept = default;

std::optional<TriangleScene::Met> TriangleScene::first_front(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query = embree_query(ray);
    rtcIntersect1(scene_->scene.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Met{query.hit.primID, static_cast<double>(query.ray.tfar)};
}

}  // namespace reliefbench
