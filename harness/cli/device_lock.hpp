#pragma once

#include "gpu/device.hpp"

#include <functional>
#include <optional>

namespace CLI {
class App;
}

namespace reliefbench {

/// One process at a time measures times on a device: two would measure each other. Held while it lives; the system
/// lets go of it when its process ends, however that ends. All CPU devices are one: they share the processors.
class DeviceLock {
public:
    /// Waits while another process holds it, and says for which one. `is_interrupted` (may be empty) ends the waiting.
    explicit DeviceLock(const gpu::DeviceInfo& device, const std::function<bool()>& is_interrupted = {});
    ~DeviceLock();
    DeviceLock(DeviceLock&& other) noexcept;
    DeviceLock& operator=(DeviceLock&& other) noexcept;

    /// False when waiting was ended.
    bool is_held() const { return descriptor_ >= 0; }

private:
    int descriptor_ = -1;
};

/// Whether to measure beside others all the same.
struct DeviceSharing {
    bool share = false;

    void add_to(CLI::App& command);
    /// Empty where the device is shared.
    std::optional<DeviceLock> lock(const gpu::DeviceInfo& device,
                                   const std::function<bool()>& is_interrupted = {}) const;
};

}  // namespace reliefbench
