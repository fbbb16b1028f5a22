#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <string>
#include <type_traits>

namespace reliefbench::embree {

/// Embree's objects with owners. For the files behind which Embree stays; no interface names it.

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

}  // namespace reliefbench::embree
