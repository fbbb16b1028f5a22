#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace reliefbench::gpu {

class Device;

/// What the driver tells of a device at one moment; empty: not told.
struct DeviceState {
    std::optional<double> clock_mhz;
    std::optional<double> memory_clock_mhz;
    std::optional<double> temperature_c;
    /// Slowed down for heat or power, not because it idles or because clocks were set.
    std::optional<bool> throttled;
};

class DeviceStateSource {
public:
    virtual ~DeviceStateSource() = default;
    virtual DeviceState read() = 0;
};

/// Where the device's state can be read: NVML for NVIDIA's driver, sysfs for amdgpu, the processors' clocks for a CPU
/// device. Never null: where nothing tells, all is empty.
std::unique_ptr<DeviceStateSource> open_device_state(const Device& device);

// The sources; null where there is none. `pci_address` is written as in "0000:65:00.0".

/// `library`: NVIDIA's Management Library, by path or by the name that the loader searches for.
std::unique_ptr<DeviceStateSource> open_nvml_state(const std::string& library, const std::string& pci_address);

/// `pci_devices`: /sys/bus/pci/devices.
std::unique_ptr<DeviceStateSource> open_amdgpu_state(const std::filesystem::path& pci_devices,
                                                     const std::string& pci_address);

/// `processors`: /sys/devices/system/cpu. The clock is the mean over all processors.
std::unique_ptr<DeviceStateSource> open_cpu_state(const std::filesystem::path& processors);

}  // namespace reliefbench::gpu
