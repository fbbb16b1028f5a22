#pragma once

#include "gpu/handles.hpp"

#include <functional>
#include <string>

namespace reliefbench::gpu {

/// Commands recorded once and submitted as often as wanted, once at a time. What they refer to must outlive it.
class Recording {
public:
    /// `what` completes "cannot ..." in an Error. All that the commands wrote is visible to the host after `wait`.
    Recording(const Device& device, std::string what,
              const std::function<void(const vk::raii::CommandBuffer&)>& record);
    /// Waits for a submission that is under way.
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    void submit();
    /// For the end of what was submitted.
    void wait();

private:
    const DeviceHandles* handles_;
    std::string what_;
    vk::raii::CommandBuffer commands_{nullptr};
    vk::raii::Fence fence_{nullptr};
    bool under_way_ = false;
};

}  // namespace reliefbench::gpu
