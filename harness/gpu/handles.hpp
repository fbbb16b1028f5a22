#pragma once

#include "core/error.hpp"
#include "gpu/device.hpp"
#include "gpu/vulkan.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench::gpu {

struct MessageLog {
    std::mutex mutex;
    std::vector<std::string> messages;
};

/// What gpu/loop_limit.hpp found, once it has looked.
struct KnownLoopLimit {
    bool is_known = false;
    std::optional<std::uint32_t> iterations;
};

/// Vulkan's side of a Device. Members are destroyed in reverse order.
struct DeviceHandles {
    DeviceInfo info;
    /// DeviceOptions: who is told of submissions.
    std::function<void(int passes)> on_submit;
    std::function<void()> on_end;
    /// On the heap: the driver keeps its address.
    std::unique_ptr<MessageLog> messages = std::make_unique<MessageLog>();
    vk::raii::Context context{vkGetInstanceProcAddr};
    vk::raii::Instance instance{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger{nullptr};
    vk::raii::PhysicalDevice physical_device{nullptr};
    vk::PhysicalDeviceMemoryProperties memory;
    vk::raii::Device device{nullptr};
    std::uint32_t queue_family = 0;
    vk::raii::Queue queue{nullptr};
    vk::raii::CommandPool command_pool{nullptr};
    vk::raii::PipelineCache pipeline_cache{nullptr};
    /// On the heap: found out of a Device that is const.
    std::unique_ptr<KnownLoopLimit> loop_limit = std::make_unique<KnownLoopLimit>();
    /// Likewise, by gpu/anisotropic_gradients.hpp.
    std::unique_ptr<std::optional<bool>> anisotropy_takes_gradients = std::make_unique<std::optional<bool>>();

    /// Whether the device is still there; it has nothing to do then.
    bool wait_until_idle() const;
};

/// Runs `action`; what Vulkan throws becomes an Error: "cannot <what> on <device>: <Vulkan's words>".
template <typename Action>
auto translate_errors(std::string_view what, const std::string& device, Action&& action) {
    try {
        return std::forward<Action>(action)();
    } catch (const vk::DeviceLostError&) {
        fail(
            "cannot {} on {}: the device was lost. A draw that takes too long or a driver fault does this; try fewer "
            "steps or a smaller resolution, and see the system's log",
            what, device);
    } catch (const vk::OutOfDeviceMemoryError&) {
        fail("cannot {} on {}: out of device memory. Choose a smaller height map or resolution", what, device);
    } catch (const vk::SystemError& error) {
        fail("cannot {} on {}: {}", what, device, error.what());
    }
}

}  // namespace reliefbench::gpu
