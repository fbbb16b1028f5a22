#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "technique/base_on_device.hpp"
#include "technique/renderer.hpp"

#include <string>
#include <vector>

namespace reliefbench {

struct SceneOnDevice::Textures {
    Textures(const gpu::Device& device, const HeightMap& map, const Albedo& albedo);

    Resolution size;
    std::string height_map_hash;
    gpu::Texture heights;
    gpu::Texture derivatives;
    gpu::Texture albedo;
    vk::raii::Sampler linear_repeat;
    vk::raii::Sampler nearest_repeat;
    BasesOnDevice bases;

    /// What preparation passes see.
    std::vector<gpu::Binding> height_bindings() const;
    /// What draws see.
    std::vector<gpu::Binding> all_bindings() const;
};

vk::Format vulkan_format(HeightFormat format);

/// Heights as the format stores them, row 0 first.
std::vector<std::byte> encode_heights(const Image<float>& heights, HeightFormat format);

}  // namespace reliefbench
