#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "technique/base_on_device.hpp"
#include "technique/blue_noise.hpp"
#include "technique/material_mips.hpp"
#include "technique/renderer.hpp"

#include <memory>
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
    BlueNoiseOnDevice blue_noise;

    /// What preparation passes see.
    std::vector<gpu::Binding> height_bindings() const;
    /// What draws see besides, where the material has no mips.
    std::vector<gpu::Binding> material_bindings() const;
    /// What they see in its place; shared by who draws with it, and not there while nobody does.
    std::shared_ptr<const MaterialMips> material_mips() const;

private:
    const gpu::Device* device_;
    /// What is in it is a matter of who draws, not of the scene.
    mutable std::weak_ptr<const MaterialMips> mips_in_use_;
};

vk::Format vulkan_format(HeightFormat format);

/// Heights as the format stores them, row 0 first.
std::vector<std::byte> encode_heights(const Image<float>& heights, HeightFormat format);

}  // namespace reliefbench
