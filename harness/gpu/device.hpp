#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace reliefbench::gpu {

enum class DeviceType { discrete, integrated, virtual_gpu, cpu, other };

std::string to_string(DeviceType type);

/// A Vulkan device as results record it. Plain data.
struct DeviceInfo {
    /// Position in the loader's list: what `--device N` takes.
    int index = 0;
    std::string name;
    DeviceType type = DeviceType::other;
    /// "llvmpipe", "NVIDIA", ... and the driver's own version text.
    std::string driver;
    std::string driver_version;
    /// "1.3.230".
    std::string api_version;
    std::uint32_t vendor_id = 0;
    std::uint32_t device_id = 0;
    /// "0000:65:00.0"; empty where the driver does not tell.
    std::string pci_address;
    /// Nanoseconds per timestamp tick, and how many bits of a timestamp count.
    double timestamp_period_ns = 0;
    int timestamp_valid_bits = 0;
    int max_image_side = 0;
    int max_tessellation_factor = 0;
    std::uint64_t max_storage_buffer_bytes = 0;
    /// Of samplers: of the feature samplerAnisotropy, and to either side.
    double max_anisotropy = 1;
    double max_lod_bias = 0;
    /// Of feature_names(), those that the device has; all of them are enabled.
    std::vector<std::string> features;
    /// Empty, or why reliefbench cannot run on it ("Vulkan 1.2 only, 1.3 is needed").
    std::string unusable_reason;

    bool has_feature(const std::string& name) const;
};

/// Among a device's features: it tells registers, spills and code size of what it compiled.
inline constexpr const char* pipeline_executable_feature = "pipelineExecutableInfo";

/// Every optional feature that technique.json or the harness can ask for: Vulkan's own names ("tessellationShader",
/// "shaderFloat64"), and extensions with what belongs to them ("VK_EXT_mesh_shader", "VK_KHR_ray_query"). Which
/// structures they stand in is told in gpu/device_features.cpp, one row each.
std::vector<std::string> feature_names();

/// In the loader's order, unusable ones too. No loader or no device is an Error that says which package brings one.
std::vector<DeviceInfo> list_devices();

/// Position in `devices` of the one that `choice` names: an index, a name or a part of one in any case, or "" for the
/// best (discrete, integrated, virtual, CPU). An Error lists what there is.
std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::string& choice);

struct DeviceOptions {
    /// As choose_device takes it; when empty, the environment variable RELIEFBENCH_DEVICE decides.
    std::string choice;
    /// The Khronos validation layer, with synchronisation validation.
    bool validation = false;
    /// Told before so many passes are submitted together, and when they have ended (or the device gave up on them), in
    /// the same order: for who watches that the device does not hang. May be empty, but both or none.
    std::function<void(int passes)> on_submit = {};
    std::function<void()> on_end = {};
};

struct DeviceHandles;
class SharedPipelines;
class ShaderCache;

/// A Vulkan device with one queue. Used by one thread at a time. What the world does to it (a lost device, no memory)
/// is an Error.
class Device {
public:
    explicit Device(const DeviceOptions& options = {});
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const DeviceInfo& info() const;
    /// Warnings and errors of the validation layer so far: one of them fails a test run.
    std::vector<std::string> validation_messages() const;
    /// Asks the driver, after something failed: a lost device does nothing any more, another Device is needed. Waits
    /// for what the device has to do.
    bool is_lost() const;

    /// For code that records Vulkan commands (gpu/handles.hpp).
    const DeviceHandles& handles() const { return *handles_; }
    /// Compiled shaders by the key that their owner gives them: a sweep over parameters compiles GLSL once.
    ShaderCache& shader_cache() const { return *shader_cache_; }
    /// Pipelines by what they are made of: the views of a sweep share them.
    SharedPipelines& shared_pipelines() const { return *shared_pipelines_; }

private:
    std::unique_ptr<DeviceHandles> handles_;
    std::unique_ptr<ShaderCache> shader_cache_;
    std::unique_ptr<SharedPipelines> shared_pipelines_;
};

}  // namespace reliefbench::gpu
