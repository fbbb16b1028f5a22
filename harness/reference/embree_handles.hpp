#pragma once

#include "core/error.hpp"
#include "scene/ray.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <string>
#include <type_traits>

namespace reliefbench::embree {

/// Embree's objects with owners, how scenes of one geometry are built, and what is asked of them. For the files behind
/// which Embree stays; no interface names it.

template <auto release>
struct Release {
    template <typename Handle>
    void operator()(Handle* handle) const {
        release(handle);
    }
};

using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release<rtcReleaseDevice>>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release<rtcReleaseScene>>;
using GeometryHandle = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release<rtcReleaseGeometry>>;

/// With the message of the device's last error. Stays where it is, as the device refers to that.
struct BuiltScene {
    std::string message;
    Device device;
    SceneHandle scene;
};

/// An error function of devices: `kept` is a string.
inline void keep_message(void* kept, RTCError, const char* message) {
    *static_cast<std::string*>(kept) = message;
}

#if defined(__SANITIZE_THREAD__)
constexpr bool under_thread_sanitizer = true;
#elif defined(__has_feature)
constexpr bool under_thread_sanitizer = __has_feature(thread_sanitizer);
#else
constexpr bool under_thread_sanitizer = false;
#endif

/// ThreadSanitizer does not see how the threads of Embree's own scheduler, which is not compiled with it, wait for each
/// other while they build: one thread builds there.
constexpr const char* configuration = under_thread_sanitizer ? "threads=1" : nullptr;

/// Builds the scene, robust, of one geometry, which fill(geometry) sets; it returns whether it got its buffers. Throws
/// Error where that does not do: Embree cannot build `what`; `remedy` says what helps.
template <typename Fill>
void build(BuiltScene& built, RTCGeometryType type, const std::string& what, const char* remedy, const Fill& fill) {
    built.device.reset(rtcNewDevice(configuration));
    if (!built.device) fail("Embree gives no device for {}: check the package libembree3-3", what);
    rtcSetDeviceErrorFunction(built.device.get(), keep_message, &built.message);
    built.scene.reset(rtcNewScene(built.device.get()));
    rtcSetSceneFlags(built.scene.get(), RTC_SCENE_FLAG_ROBUST);
    const GeometryHandle geometry(rtcNewGeometry(built.device.get(), type));
    if (fill(geometry.get())) {
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(built.scene.get(), geometry.get());
        rtcCommitScene(built.scene.get());
    }
    if (rtcGetDeviceError(built.device.get()) == RTC_ERROR_NONE) return;
    fail("Embree cannot build {} ({}): {}", what, built.message, remedy);
}

/// For rtcIntersect1, of all that the ray meets from t = 0 on.
inline RTCRayHit first_hit_query(const Ray& ray) {
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

}  // namespace reliefbench::embree
