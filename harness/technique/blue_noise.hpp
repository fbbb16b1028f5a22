#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "scene/image.hpp"

#include <filesystem>
#include <optional>

namespace reliefbench {

/// Its name in harness/shaders/library/pixel_noise.glsl.
inline constexpr const char* blue_noise_name = "blue_noise";

/// A texture of 64 × 64 values in (0, 1), (rank + ½)/4096 with the ranks of void_and_cluster. They are read from the
/// cache folder where they are, and else made and written there; empty: made.
Image<float> load_blue_noise(const std::filesystem::path& cache);

/// The same on the device, from when it is first asked for.
class BlueNoiseOnDevice {
public:
    explicit BlueNoiseOnDevice(const gpu::Device& device) : device_(&device) {}

    /// It must outlive what is bound.
    gpu::Binding binding(const std::filesystem::path& cache) const;

private:
    const gpu::Device* device_;
    /// What is in them is a matter of who draws, not of the scene.
    mutable std::optional<gpu::Texture> texture_;
    mutable std::optional<vk::raii::Sampler> sampler_;
};

}  // namespace reliefbench
