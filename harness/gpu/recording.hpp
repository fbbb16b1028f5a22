#pragma once

#include "gpu/handles.hpp"

#include <functional>
#include <string>

namespace reliefbench::gpu {

/// Commands recorded once and submitted as often as wanted, once at a time. What they refer to must outlive it.
class Recording {
public:
    /// `what` completes "cannot ..." in an Error. All that the commands wrote is visible to the host after `wait`.
    /// `passes`: how many there are in it, of which each may take as long as DeviceOptions::on_submit's owner allows.
    Recording(const Device& device, std::string what, const std::function<void(const vk::raii::CommandBuffer&)>& record,
              int passes = 1);
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
    int passes_;
    vk::raii::CommandBuffer commands_{nullptr};
    vk::raii::Fence fence_{nullptr};
    bool under_way_ = false;
};

}  // namespace reliefbench::gpu
